// A chapter's hard cases as a program of their own.
#include "support/hard_cases.hpp"

int main(int argc, char** argv) { return hard_cases::program(argc, argv); }

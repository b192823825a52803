#include <cstdio>
int main() { std::printf("2 m\n"); }

#include "support/questions.hpp"

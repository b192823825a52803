// What a student's file may include beside the prelude: build.mjs looks up here which headers of
// Eigen the page's compiler gets.
#pragma once
#include <Eigen/Dense>

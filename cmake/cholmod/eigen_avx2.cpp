// SPDX-License-Identifier: GPL-3.0-or-later
// eigen_avx2.cpp: the dense routines for processors with AVX2 and FMA. Eigen's namespace has another name
// here, else the linker would take some of these functions for those that serve every processor.
#include "eigen_routines.h"

const DenseRoutines<double> routinesForAvx2 = eigenRoutines<double>;

// SPDX-License-Identifier: BSD-3-Clause
// What the stages' C++ and their shaders both know: compiled as both (Shaders/Limits.h).

// Samples of a pixel that are looked at, at the most.
const int WFV_MOST_SAMPLES = 16;

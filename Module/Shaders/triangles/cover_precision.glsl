// SPDX-License-Identifier: BSD-3-Clause
// Fragment side of the pre-clip: what is in double.

// Rays and edges in double, so that what is thinner than float32 turns a ray is decided too.
#ifdef GL_ARB_gpu_shader_fp64
#define WFV_DOUBLES WFV_FP64
#else
#define WFV_DOUBLES 0
#endif
#if WFV_DOUBLES
#define WFV_EDGE dvec3
#define WFV_SIDE double
#else
#define WFV_EDGE vec3
#define WFV_SIDE float
#endif

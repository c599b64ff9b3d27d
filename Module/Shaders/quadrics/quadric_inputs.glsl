// SPDX-License-Identifier: BSD-3-Clause
// Fragment side of spheres, cylinders and tubes: what it is given, and what it finds.

flat in vec4 wfvSphere;
flat in vec4 wfvOther;
flat in vec2 wfvShare;

float wfvDepth = 0.0; // window depth here, 0 to 1
bool wfvHide = false; // not covered: discarded once the stock shader has run
bool wfvFront = false; // seen from outside
vec3 wfvNormal = vec3(0.0); // towards the eye, view coordinates
vec3 wfvSurface = vec3(0.0); // the point itself, view coordinates
float wfvAlong = 0.0; // where on the length, 0 to 1

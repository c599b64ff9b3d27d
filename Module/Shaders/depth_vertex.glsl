// SPDX-License-Identifier: BSD-3-Clause
// Where this vertex is, in view coordinates, for the depth of the fragments.
out vec3 wfvPlaceVSOutput;

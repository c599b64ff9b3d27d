// SPDX-License-Identifier: BSD-3-Clause
// Debug view: what can happen to a primitive, and its colour. Documentation/debug-view.md
// shows them; a test holds that page against this file.

const int WFV_KIND_STRAIGHT = 0;       // no edge leaves its chord by more than the tolerance
const int WFV_KIND_REAR = 1;        // meets a straight seam: split, or ray-tested on both sides
const int WFV_KIND_POLE = 2;        // ray-tested: holds a pole or the antipode, or meets a discontinuity
const int WFV_KIND_EXACT = 3;       // ray-tested: curved by more than the tolerance, or all are
const int WFV_KIND_VERTEX = 4;      // projected, as it is or cut into smaller ones
const int WFV_KIND_OTHER = 5;       // a line or a point

const vec3 WFV_COLOR_STRAIGHT = vec3(0.90, 0.90, 0.90);
const vec3 WFV_COLOR_REAR = vec3(0.34, 0.71, 0.91);
const vec3 WFV_COLOR_POLE = vec3(0.84, 0.37, 0.00);
const vec3 WFV_COLOR_EXACT = vec3(0.00, 0.62, 0.45);
const vec3 WFV_COLOR_VERTEX = vec3(0.62, 0.66, 0.78);
const vec3 WFV_COLOR_OTHER = vec3(0.90, 0.62, 0.00);

// The kind, in the bits of wfvMode above those of the covering.
const int WFV_KIND_UNIT = 2048;

vec3 wfvKindColor(int kind)
{
  return kind == WFV_KIND_STRAIGHT ? WFV_COLOR_STRAIGHT
    : kind == WFV_KIND_REAR    ? WFV_COLOR_REAR
    : kind == WFV_KIND_POLE    ? WFV_COLOR_POLE
    : kind == WFV_KIND_EXACT   ? WFV_COLOR_EXACT
    : kind == WFV_KIND_VERTEX  ? WFV_COLOR_VERTEX
                               : WFV_COLOR_OTHER;
}

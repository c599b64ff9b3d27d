// SPDX-License-Identifier: BSD-3-Clause
// The numbers of refine_chord.glsl and refine.glsl. Compiled as C++ as well.

// Families of projections, by where they are discontinuous.
const int WFV_TEARS_MERIDIAN = 0;  // the half plane behind the eye, through the vertical axis
const int WFV_TEARS_AZIMUTHAL = 1; // the rim, and the direction behind the eye
const int WFV_TEARS_PLANAR = 2;    // the plane of the eye
const int WFV_TEARS_FACES = 3;     // the borders of the faces of a cube

// Radians: no chord is longer, because colours and textures are interpolated along it.
const float WFV_LONGEST_CHORD = 0.08;

// A share of the distance from a pole or an antipode: no longer edge is judged by its middle.
const float WFV_NEAR_SINGULARITY = 0.5;

// How many times longer than the bound for all directions an edge may be that is judged by its
// middle, squared.
const float WFV_LONGER2 = 16.0;

// Over the distance of an edge's middle from the chord: the farthest place is beside the middle.
const float WFV_MIDDLE_SAFETY = 1.25;

// Times as far as the nearer end: an edge to a farther end is split, whatever its angle.
const float WFV_STEEPEST = 4.0;

// Tolerances that the middle of an edge may be drawn from its place along the chord.
const float WFV_ALONG = 4.0;

// A chord beside a round rim may be off by no more than this share of its distance from the rim, in
// pixels; and it may always be off by this share of the tolerance.
const float WFV_OF_ROW = 0.02;
const float WFV_LEAST_OF_TOLERANCE = 0.015625;

// Radians: an edge outside of the map that is shorter is not split.
const float WFV_OUTSIDE_CHORD = 0.1;

// Factors of the near radius. An edge nearer than WFV_DEEP is not refined. One that reaches from there
// beyond WFV_INSIDE is split at WFV_CUT.
const float WFV_INSIDE = 0.9995;
const float WFV_CUT = 0.999;
const float WFV_DEEP = 0.998;

// Far radii. An edge to an end farther than this is split, because float32 holds no square of it.
const float WFV_BEYOND = 4.0;

// Radii of the circle of the eyes: a point farther from its axis is seen along a ray that turns
// little.
const float WFV_CIRCLE_FAR = 4.0;

// Radii of the circle of the eyes: what is left out between the rim of what an eye does not see and
// the first piece, at the least and at the most. Beside the eye less is visible, but takes too long.
const float WFV_LEAST_UNSEEN = 1e-5;
const float WFV_MOST_UNSEEN = 0.02;

struct WfvRefine
{
  int tears;         // WFV_TEARS_MERIDIAN, ...
  float tolerance;   // pixels
  float tinyAngle2;  // squared radians of an edge that is never split
  float circle;      // radius of the circle that the eye's rays begin on, scene units; 0: a point
  float nearCircle;  // the same, where it is the same for all rays; else 0
  float fade;        // how much more the rays turn because the circle fades; 1: no fade
  float beyondCosine; // of the angle from the axis of a round or planar map beyond which nothing is drawn
  float rimCosine;   // of the angle at which triangles are cut at the rim of a round map
  float rimChord;    // the longest edge across that rim, radians; 0: nothing is cut there
  float rimPixels;   // its radius, pixels
  float unseen;      // length of an edge into what no ray of the eye meets, scene units a scene unit of
                     // distance squared
  float endChord;    // planar maps: the longest edge across that angle, radians
  float depthBend;   // stereo that shifts by depth: NDC a unit of depth; 0: another model
};

// An end of an edge.
struct WfvEnd
{
  float reach;    // length of place
  vec3 place;     // in the map's own frame, scene units
  vec3 seen;      // where the eye sees it, as if the eye were the origin
  float distance; // of seen; 0: no ray of the eye meets it
  float limit;    // wfvLimitOf(seen)
  vec2 pixel;     // wfvPixelOf(seen, distance)
};

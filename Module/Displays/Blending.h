// SPDX-License-Identifier: BSD-3-Clause
// Even light where the pictures of projectors overlap.
#ifndef WideFoVDisplaysBlending_h
#define WideFoVDisplaysBlending_h

#include "Table.h"

namespace wfv::displays
{
enum class Masks
{
  Computed, // from where the pictures overlap
  Given,    // the brightness that the tables have
};

// Sets brightness and lift of all tables, one a projector, from where they overlap. A projector's
// share of a place is the square of how far it is inside of its picture, divided by the sum of
// these squares of all projectors that light the place: shares are smooth and their sum is 1. They
// are the brightness, unless the masks are given. A projector of black level B, below 1, shows
// B + (1 - B) x for the linear value x. The lift makes black as bright everywhere as where most
// black adds up. Directions of points count from the eye, metres.
void Blend(std::vector<Table>& tables, const std::vector<double>& blackLevels, const vec3& eye,
  Masks masks = Masks::Computed);
}

#endif

// SPDX-License-Identifier: BSD-3-Clause
// Random views of a subject, and the batch they make: one picture.
#ifndef WideFoVStressViews_h
#define WideFoVStressViews_h

#include "Cases.h"
#include "Drawing.h"

#include <cstdint>
#include <string>
#include <vector>

namespace wfv
{
namespace stress
{
// One picture of a run; what it shows follows from these and the seed.
struct BatchId
{
  std::string Projection;
  std::string Case;
  int Number = 0; // from 0, of this projection and case
};

struct Batch
{
  BatchId Id;
  std::uint64_t Seed = 0;
  Subject What;
  test::Shot Shot;
  bool Closed = false;
};

Batch MakeBatch(const BatchId& id, std::uint64_t seed);

// The pictures of one projection that have at least so many primitives together, every
// case in proportion to its share and at least once; the cases in turn.
std::vector<BatchId> PlanBatches(
  const std::string& projection, const std::vector<std::string>& cases, long primitives);

// A unit vector at right angles to the direction.
vec3 FrameUp(Random& random, const vec3& direction);

// The command that draws this batch alone.
std::string Reproducer(const Batch& batch, const std::string& technique, double tolerance);
}
}

#endif

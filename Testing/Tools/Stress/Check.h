// SPDX-License-Identifier: BSD-3-Clause
// Draws one batch with one technique and says what is wrong with it.
#ifndef WideFoVStressCheck_h
#define WideFoVStressCheck_h

#include "Counts.h"
#include "HitCounter.h"
#include "Metrics.h"
#include "Views.h"

#include <memory>
#include <string>
#include <vector>

namespace wfv
{
namespace stress
{
struct Technique
{
  std::string Name;
  int Value;        // vtkWideFoVPass::Techniques
  double Tolerance; // of the pass, pixels
  double B;         // what the ray caster explains within, pixels
  bool Projects;    // draws chords
};

struct Verdict
{
  Counts Count;
  std::vector<std::string> Lines; // the first few pixels that are wrong, with both answers
};

// Windows that outlive many batches.
class Checker
{
public:
  Checker();
  ~Checker();

  // The batch to check from now on; casts its rays.
  void SetBatch(const Batch& batch);

  Verdict Check(const Technique& technique);

private:
  struct Sample
  {
    int I;
    int J;
    reference::Hit Truth;
  };
  void CastRays();
  void CountBadValues(Verdict& verdict) const;
  void CountHits(const Technique& technique, Verdict& verdict);
  void Compare(
    const reference::DrawnPicture& drawn, const Technique& technique, Verdict& verdict) const;
  bool IsRight(const reference::WorstPixel& pixel, double b, Counts& count) const;
  bool IsDepthTie(const reference::WorstPixel& pixel, double b) const;
  bool LookClosely(reference::WorstPixel& pixel, double b, Counts& count) const;
  bool TiesAt(vec2 ndc, vtkIdType cell) const;
  void Say(Verdict& verdict, const std::string& what) const;

  test::Drawing Drawing;
  HitCounter Counter;
  Batch Current;
  std::unique_ptr<reference::RayCaster> Caster;
  std::vector<Sample> Samples;
  double BesideNear = 0; // of the near radius: so much nearer a triangle may be drawn
};
}
}

#endif

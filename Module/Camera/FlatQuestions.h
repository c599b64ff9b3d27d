// SPDX-License-Identifier: BSD-3-Clause
// What VTK's own pickers and handles ask, who take the picture for a flat one. None of them can be
// replaced from outside, but each asks camera and renderer in an order of its own, which tells who
// asks, and is answered so that what it makes of the answers is right in the wide view:
//
// * vtkPicker and what derives from it: where the camera is, what it looks at, how deep that is in
//   the picture, what place a pixel shows at that depth, and between which planes to look. The last
//   two make the line that it picks along: the ray of the view, beside and behind too. Then it asks
//   for the middle of that line, and for two corners of the window at its depth: how far these are
//   apart is the unit of its tolerance.
// * A handle that is dragged, with its vtkFocalPlanePointPlacer: how deep the place is that it is
//   dragged to, what the camera looks at, in which direction, and then for a pixel the same as a
//   picker. It moves in a plane that faces the camera, which beside it is seen from its edge: so it
//   keeps its distance from the eye instead.
// * A vtk3DWidget whose handles are to be as large as a share of the window: how deep the place is
//   that was picked last, and which places the window's lower left and upper right corners show at
//   that depth.
#ifndef WideFoVFlatQuestions_h
#define WideFoVFlatQuestions_h

#include <array>

namespace wfv
{
// A ray, world: where it starts, its unit direction, and the distances between which to look.
struct PickRay
{
  std::array<double, 3> Origin;
  std::array<double, 3> Direction;
  std::array<double, 2> Range;
};

class FlatQuestions
{
public:
  // What a camera is asked.
  void AskPosition(const double position[3]);
  void AskFocalPoint(const double focalPoint[3]);

  // The direction of view. True where a handle asks, which is to be told 0, 0, 0: then it asks for
  // no distance from the plane of the focal point.
  bool AskDirection();

  // A place of the world that is asked for, and its depth in the picture.
  void AskDepth(const double world[3], double depth);

  // Who asks for a place of the picture.
  enum class Asker
  {
    Any,
    Picker,       // which is to be told the place by Answer
    PickerCorner, // which is to be told GetCorner
    WidgetCorner  // a widget that sizes its handles: asks for the upper corner after the lower one
  };

  // A place of the picture (NDC) that is asked for, at this depth. A handle's depth becomes that of
  // the place that it is dragged to.
  Asker AskPlace(const double ndc[2], double& depth);

  // Of a picker whose line is known: next it asks for the unit of its tolerance.
  void ExpectMiddle() { this->Last = Step::PickerRange; }

  // The middle of the picker's line, or a place as far from it as the window's corners are apart,
  // which are so many scene units.
  void GetCorner(double diagonal, double place[3]);

  // The middle of the picker's line, or the place of the widget, world.
  const std::array<double, 3>& GetMiddle() const { return this->Middle; }

  // place: what to tell the picker, world. The ray begins at the position asked for.
  void Answer(const PickRay& ray, double place[3]);

  // The planes that belong to the answer, once; false for all others who ask.
  bool AskRange(double range[2]);

private:
  Asker AskCorner(const double ndc[2], bool afterLower);

  enum class Step
  {
    None,
    Position, // of a picker, from here on
    PickerFocalPoint,
    PickerDepth,
    PickerPlace,
    PickerRange,
    PickerMiddle,
    PickerCorner,
    World, // of a handle or a widget, from here on
    WorldLower,
    WorldFocalPoint,
    Direction,
    HandleFocalPoint,
    HandleDepth
  };
  Step Last = Step::None;
  std::array<double, 3> Position;
  std::array<double, 3> FocalPoint;
  std::array<double, 3> Middle;
  std::array<double, 3> World; // asked for last, of which WorldDepth is
  bool AtMiddle = true;        // the corner that was told last
  double FocalDepth = 0;
  double WorldDepth = 0;
  std::array<double, 2> Range;
};
}

#endif

// SPDX-License-Identifier: BSD-3-Clause
// What the pass and the mapper choose from: one stage object a variant.
#ifndef WideFoVStages_h
#define WideFoVStages_h

#include "Drawables/PropTraits.h"
#include "Frame/BufferScale.h"
#include "Frame/DirectionTextures.h"
#include "Frame/FineDepth.h"
#include "Frame/FrameStatistics.h"
#include "Frame/GlyphDraw.h"
#include "Frame/ProgramMemory.h"
#include "Frame/ShaderClock.h"
#include "Frame/ShaderFolder.h"
#include "Frame/ShaderMemory.h"
#include "Frame/vtkWideFoVStage.h"
#include "Projections/Bounds/Visibility.h"
#include "Refine/Refiner.h"
#include "vtkWideFoVAbi.h"

#include <array>
#include <chrono>
#include <cstdint>
#include <memory>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkActor;
class vtkInformation;
VTK_ABI_NAMESPACE_END

namespace wfv
{
// The variants and the choice between them.
class Stages
{
public:
  Stages();

  // Pixels: under this a chord stands for no edge. The rasterizer snaps the ends of a chord by
  // up to 1/128 of a pixel, and the lens between the two is as thin as that; and who asks for
  // so little asks for exact depth and attributes too. Everything is ray-tested.
  static constexpr double LeastTolerance = 0.05;
  static bool AllowsChords(double tolerance) { return tolerance >= LeastTolerance; }

  // Every triangle is then drawn by the ray of each pixel.
  static bool IsExactTechnique(int technique, double tolerance);

  // Before the props of a frame. technique: vtkWideFoVPass::Techniques; one that this
  // OpenGL cannot becomes AUTO, with a warning.
  void Begin(vtkRenderer* renderer, vtkWideFoVCamera* camera, int technique, double tolerance);

  // After them.
  void End()
  {
    this->Textures.Unbind();
    this->Fine.End();
    this->Glyphs.Finish();
  }

  void ReleaseGraphicsResources(vtkWindow* window)
  {
    this->Textures.ReleaseGraphicsResources(window);
    this->Fine.ReleaseGraphicsResources(window);
    this->Glyphs.ReleaseGraphicsResources(window);
    this->Programs.ForgetAll();
    this->Folder.Forget();
  }

  // How many times larger on each side a frame is shown than drawn (1), from the next Begin on.
  // Props keep the variant that they have where it is drawn as large as that: no other program has
  // to be made while a view moves, and none is dearer.
  void SetEnlargement(int times) { this->Enlargement = times; }

  // Pixels round the picture on each side that are drawn too, from the next Begin on (0): passes
  // over the picture look at its neighbours.
  void SetBorder(int pixels) { this->Border = pixels; }

  // For all variants, from the next draw on.
  void SetDebugView(bool debugView);

  // The same: whether many props of the frame have wide lines.

  // Whether what is not seen is left out (true).
  void SetCulling(bool culling) { this->Culling = culling; }

  // The stage for a prop: the cheapest that the technique allows it. Prepares its vertex
  // buffer, too. bounds: the prop's, which have just been asked for; nullptr where it has none.
  vtkWideFoVStage* Choose(vtkProp* prop, const double* bounds, wfv::PropTraits& traits);

  // True where the prop cannot be drawn, which is said once.
  bool IsLeftOut(vtkProp* prop, wfv::PropTraits& traits) const;

  // True where nothing of the prop can be in the picture, or it cannot be drawn: it need not be.
  bool IsCulled(vtkProp* prop, const double* bounds, wfv::PropTraits& traits) const;

  // What surely holds the picture of what has these bounds, for the eye that is drawn.
  wfv::Pictures GetPictures(const double* bounds) const;

  // Distances, from the middle between the eyes, of the nearest and of the farthest point of what
  // has these bounds; the clip radii where there are none.
  wfv::vec2 GetDistances(const double* bounds) const;

  // From world to view coordinates, row-major.
  const double* GetWorldToView() const { return this->WorldToView; }

  // Another one whenever what Choose and IsCulled go by has changed, but the prop.
  std::uint64_t GetViewNumber() const { return this->ViewNumber; }

  // Fills in the view that the meshes of an actor, drawn with this stage, are refined for. False if
  // the stage draws all triangles as they are.
  bool GetRefineView(const vtkWideFoVStage* stage, vtkActor* actor, wfv::RefineView& view);

  // From the actor's coordinates to the map's own frame, row-major.
  void GetToMap(vtkActor* actor, double matrix[16]) const;

  // Where the frame is seen from.
  wfv::WorldEye Eye;

  // What of it has been drawn.
  wfv::FineDepth Fine;

  // Copies of glyph mappers.
  wfv::GlyphDraws Glyphs;

  // Of what it drew so far, the keys: many props are drawn by an actor in their place that has the
  // same ones.
  std::vector<const vtkInformation*> DrawnKeys;

  // What this frame did and left out.
  wfv::FrameStatistics Counts;
  std::chrono::duration<double> ClusterTime{ 0 }; // of all frames, for making clusters of meshes
  wfv::ShaderClock Shaders;

  // Adds the time since `start` to what refining took in this frame.
  void AddRefineTime(std::chrono::steady_clock::time_point start)
  {
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    this->Counts.RefineTime += took.count();
  }
  wfv::ShaderMemory Texts;
  wfv::ProgramMemory Programs;
  wfv::ShaderFolder Folder;

  // Puts one stage in the place of another in the prop's keys.
  static void Replace(vtkProp* prop, vtkWideFoVStage* from, vtkWideFoVStage* to);

  // The stage in the prop's keys, or nullptr.
  static vtkWideFoVStage* FindAttached(vtkProp* prop);

  vtkNew<vtkWideFoVStage> Projected; // auto: refined meshes; vertex
  vtkNew<vtkWideFoVStage> PreClip;   // preclip; auto: props that are not refined
  vtkNew<vtkWideFoVStage> Exact;
  vtkNew<vtkWideFoVStage> ExactInSingle; // in float32: of few triangles, all of them fat
  vtkNew<vtkWideFoVStage> Sky;

private:
  // The stage of the technique "preclip" for a prop whose rays begin all in one place.
  vtkWideFoVStage* ChooseByBounds(const double bounds[6], const wfv::PropTraits& traits);

  // Bounds in the map's own frame, as large as they are seen from any place of the eyes.
  wfv::Box GetBox(const double bounds[6]) const;

  // Fills in what is not known yet.
  static void FindTraits(vtkProp* prop, wfv::PropTraits& traits);

  // Radians: how far the points of a prop may extend beyond their centres; 0 where they are no
  // larger than a pixel.
  double GetPointFootprint(const wfv::PropTraits& traits) const;

  wfv::BufferScale Buffers;
  wfv::DirectionTextures Textures;
  double Tolerance = 0.25;
  double PixelAngle = 0;   // radians, of a pixel at the most if all were alike
  double HalfDiagonal = 1; // of the picture, pixels
  int Enlargement = 1;
  int Border = 0;
  int Technique = 0;
  const wfv::Projection* Projection = nullptr;
  bool ByPixels = false; // the rays of an eye begin in several places, or are curved
  const wfv::StereoModel* Stereo = nullptr;
  bool IsExact() const; // every triangle is ray-tested
  bool Refines() const; // meshes are refined, where their mapper can
  bool IsFat(vtkProp* prop, const double* bounds, const wfv::PropTraits& traits) const;
  bool IsCoarse(const double* bounds, const wfv::PropTraits& traits) const;
  wfv::WfvView View;
  double WorldToView[16];
  void SetPart(vtkRenderer* renderer, const float tile[4]);
  wfv::Window Part;      // of the picture, with a margin
  wfv::vec2 Pixels{ 1 }; // of the whole picture
  bool Culling = true;
  std::array<vtkWideFoVStage*, 5> GetAll();
  void Instruct(vtkWideFoVStage* stage);
  void SetEyes(vtkWideFoVCamera* camera, const wfv::StereoModel* stereo); // after SetPart
  double BaselineRadius =
    0; // of the rays' beginnings from the middle between the eyes, scene units

  // After the view is known.
  void NumberView(const wfv::StereoModel* stereo);
  std::uint64_t ViewNumber = 0;
  std::vector<double> Numbered; // what the number stands for
  const void* NumberedObjects[3] = { nullptr, nullptr, nullptr };
  double NumberedMatrix[16];

  // The present view's, made when they are first asked for.
  std::shared_ptr<const wfv::ChordLimits> GetLimits(double tolerance);
  std::shared_ptr<const wfv::LocalCurvature> Curvature;
  wfv::WfvView CurvatureView;
  const wfv::Projection* CurvatureProjection = nullptr;
  std::shared_ptr<const wfv::ChordLimits> Limits;
  wfv::vec2 LimitsPixels{ 0 };
  double LimitsTolerance = 0;
};
}

#endif

// SPDX-License-Identifier: BSD-3-Clause
// Draws a mesh through the module, and sets it beside the ray caster's picture.
#ifndef WideFoVTestDrawing_h
#define WideFoVTestDrawing_h

#include "vtkWideFoVAbi.h"

#include "Metrics.h"
#include "Projections/Projection.h"

#include <vtkSmartPointer.h>

#include <memory>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkActor;
class vtkImageData;
class vtkPolyData;
class vtkWideFoVCamera;
VTK_ABI_NAMESPACE_END

namespace wfv
{
namespace test
{
// What is drawn, and from where.
struct Shot
{
  std::string Projection = "equirectangular";
  ViewOptions Options; // the aspect is that of the size
  int Width = 512;
  int Height = 256;
  vec3 Eye{ 0 };
  vec3 Direction{ 0, 0, -1 };
  vec3 Up{ 0, 1, 0 };
};

// One line that says everything needed to draw the shot again.
std::string Describe(const Shot& shot);

// Sets the camera up as the shot says.
void PlaceCamera(vtkWideFoVCamera* camera, const Shot& shot);

// A window that outlives many shots, so that shaders are compiled once.
class Drawing
{
public:
  Drawing();
  ~Drawing();

  // What is drawn from now on.
  void SetMesh(vtkPolyData* mesh);

  vtkPolyData* GetMesh() const;

  // Draws this actor in place of the mesh from now on.
  void SetActor(vtkActor* actor);

  // And this one with it; index: in the picture's "prop", from 0.
  void AddActor(vtkActor* actor, int index);

  // Everything the data pass wrote of the last picture.
  vtkImageData* GetData() const;

  // Of the pass, pixels (0.25).
  void SetTolerance(double pixels);

  // Where the actor that shows the mesh stands, world.
  void SetActorPosition(const vec3& position);

  // vtkWideFoVPass::Techniques (default PRECLIP).
  void SetTechnique(int technique);

  // The same, of an actor that was set with SetActor.
  void SetPassTechnique(int technique);

  // Whether what is not seen is left out (yes).
  void SetCulling(bool culling);

  // Whether every technique draws the perspective (no): else it is stock VTK's, unless all is
  // exact.
  void SetDrawsPerspective(bool draws);

  // Of the last picture: draws by the vertex stage alone.
  int GetNumberOfProjectedDraws() const;

  // Whether some of the triangles that it drew were projected, and others not.
  bool WasMixed() const;

  // Of lines, pixels (1).
  void SetLineWidth(double pixels);

  // Of points, pixels (1).
  void SetPointSize(double pixels);

  // Draws the mesh; the picture is empty where the window failed.
  reference::DrawnPicture Draw(const Shot& shot);

  // Everything that the data pass read of the last picture, rows from the bottom.
  vtkImageData* GetImage() const;

  // The view and the pose (of the mesh's own coordinates) of the last picture.
  const View& GetView() const;
  reference::Pose GetPose() const;

  // 1, or 0 where the prop met no discontinuity and went without the geometry stage.
  int GetNumberOfPreClipDraws() const;

private:
  struct Internals;
  std::unique_ptr<Internals> Internal;
};

// Where a pixel looks: NDC, and longitude and latitude (view coordinates) in degrees.
std::string DescribePixel(const View& view, int width, int height, const reference::WorstPixel& p);

// Pixels of the domain with nothing drawn, pixels outside with something drawn.
struct HoleCount
{
  long Holes = 0;
  long Outside = 0;
  std::string First; // places, a line each
};
HoleCount CountHoles(const reference::DrawnPicture& picture, const View& view);

// One line of the table of results.
std::string Row(const Shot& shot, const std::string& scene, const reference::Metrics& m);

// The unexplained pixels, one line each.
std::string Details(const Shot& shot, const View& view, const reference::Metrics& m);
}
}

#endif

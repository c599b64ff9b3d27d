// SPDX-License-Identifier: BSD-3-Clause
// Rewrites the shaders of a stock mapper for a wide view. Text in, text out: no
// OpenGL, no VTK objects, so that it is tested on text.
#ifndef WideFoVShaderBuilder_h
#define WideFoVShaderBuilder_h

#include "Compat/StockEdits.h"
#include "Projections/Projection.h"
#include "vtkWideFoVAbi.h"

#include <string>

namespace wfv
{
class WFV_EXPORT ShaderBuilder
{
public:
  enum class Variant
  {
    Projected, // the vertex stage projects
    PreClip,   // a geometry stage clips, then projects
    Exact,     // the same, every triangle by the ray of each pixel, lines as exact strips
    Sky        // no primitives: the ray of each pixel (sky/SkyShaders.h)
  };

  enum class Primitive
  {
    Points,
    Lines,
    Triangles,
    Spheres,      // of the stock sphere mapper
    Cylinders,    // of the stock stick mapper
    Splats,       // of the stock point gaussian mapper
    PointSpheres, // points rendered as spheres
    Tubes         // lines rendered as tubes
  };

  // What of the material is known to be simple: constants in the shader, which is built anew
  // whenever the property changes.
  struct Material
  {
    bool NoAmbient = false;   // intensity 0
    bool NoDiffuse = false;   // intensity 0
    bool FullDiffuse = false; // intensity 1
    bool NoSpecular = false;  // intensity 0
    bool Opaque = false;      // opacity 1
  };

  // Of the view. The programs of all that is drawn are built anew where it changes.
  struct ViewTraits
  {
    const wfv::Projection* Projection = nullptr;
    const wfv::StereoModel* Stereo = nullptr; // none: no stereo
    int DepthMapping = 0;     // wfv::DepthMapping; all but linear by the fragment stage
    bool Multisample = false; // the framebuffer may have several samples a pixel
    bool Tilted = false;      // the view may have a tilt
    bool Lensed = false;      // and a lens
    bool Fades = false;       // the eyes' circle may have a fade
    bool Seam = false;        // the picture may show a seam that is curved
  };

  struct PointTraits
  {
    bool Wide = false; // wider than a pixel
  };

  struct LineTraits
  {
    bool Wide = false; // wider than the hardware draws
  };

  struct TriangleTraits
  {
    bool Edges = false;     // surface with edges
    bool EdgeFlags = false; // some edges are inside a cell
    bool ByRays = false;    // ray-tested, whatever their edges: no chords
    bool Fp64 = false;      // ray-tested ones are decided in double, where OpenGL has that
  };

  struct LightTraits
  {
    int Headlights = 0;                     // which lights are at the eye, one bit each
    const std::string* Constants = nullptr; // of wfv::SteadyLights; none: all are uniforms
  };

  struct Request
  {
    ViewTraits View;
    Variant Stage = Variant::Projected;
    Primitive Kind = Primitive::Triangles;
    PointTraits Points;
    LineTraits Lines;
    TriangleTraits Triangles;
    LightTraits Lights;
    Material Surface;
    int Runs = 1;           // of the geometry stage, which share in covering a primitive
    bool DebugView = false; // coloured by what happens to each primitive

    wfv::stock::Traits Stock; // what must be found in VTK's text
  };

  // True where this request needs the pre-clip's own geometry stage.
  static bool NeedsGeometryStage(const Request& request);

  // Before the mapper replaces its tags: the pre-clip does without the mapper's own
  // geometry stage (wide lines, edges) and brings what it did.
  static void Prepare(const Request& request, std::string& geometry, std::string& fragment);

  // After the mapper has replaced its tags: adds the projection to all stages. Every
  // output of the vertex stage, whatever it is called, is interpolated. Here and in Prepare, what
  // is not found in VTK's text leaves a mark (Compat/StockEdits.h).
  static void Finish(
    const Request& request, std::string& vertex, std::string& geometry, std::string& fragment);

  // Renames main() and appends a new one that runs `before`, the old one, `after`.
  static void WrapMain(std::string& source, const std::string& before, const std::string& after);

  // Inserts text behind the head of a shader, where declarations may stand.
  static void Declare(std::string& source, const std::string& text);
};
}

#endif

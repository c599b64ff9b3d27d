// SPDX-License-Identifier: BSD-3-Clause
// What the pass and the mapper share: the render pass object that sits in a prop's
// keys while it is drawn and adds one variant of the wide view to its shaders, and
// the choice of that variant from the prop's bounds.
#ifndef vtkWideFoVStage_h
#define vtkWideFoVStage_h

#include "Camera/Tile.h"
#include "Frame/ShaderMemory.h"
#include "Frame/SteadyLights.h"
#include "Shaders/ShaderBuilder.h"
#include "vtkWideFoVAbi.h"

#include "vtkNew.h"
#include "vtkOpenGLRenderPass.h"

namespace wfv
{
class DirectionTextures;
class Stages;
struct ProgramUses;
}

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLPolyDataMapper;
class vtkRenderer;
class vtkWideFoVCamera;

// One variant. Two objects, not one with a switch: a prop that changes its variant
// changes its key, and VTK rebuilds the shaders of that prop alone.
class vtkWideFoVStage : public vtkOpenGLRenderPass
{
public:
  static vtkWideFoVStage* New();
  vtkTypeMacro(vtkWideFoVStage, vtkOpenGLRenderPass);

  void SetVariant(wfv::ShaderBuilder::Variant variant) { this->Variant = variant; }

  wfv::ShaderBuilder::Variant GetVariant() const { return this->Variant; }

  // What the next draws see. The projection's text changes the shaders; everything
  // else is uniforms. border: pixels on each side of what is drawn that are beyond the picture.
  void SetView(vtkRenderer* renderer, vtkWideFoVCamera* camera, double tolerance, int border);

  // Never a pre-clip, not even for wide lines and surface edges: the technique "vertex".
  void SetClipless(bool clipless)
  {
    if (clipless != this->Clipless)
    {
      this->Clipless = clipless;
      this->SourceTime.Modified();
    }
  }

  // Runs of the geometry stage that share in covering a triangle: the shapes of large ones are
  // tighter. Set before anything is drawn.
  void SetRuns(int runs) { this->Runs = runs; }

  // Ray-tested triangles decided in double, where the projection has rays for that: the technique
  // "exact". Not with several samples, which would each take as long.
  void SetFp64(bool fp64)
  {
    if (fp64 != this->Fp64)
    {
      this->Fp64 = fp64;
      this->SourceTime.Modified();
    }
  }

  // Whether ray-tested triangles are decided so, as the view and its samples are now.
  bool IsFp64() const { return this->Fp64 && this->HasFp64Rays(); }

  // Sets the variant that draws everything but the triangles of mappers that refine them.
  void SetUnrefined(wfv::ShaderBuilder::Variant variant)
  {
    if (variant != this->Unrefined)
    {
      this->Unrefined = variant;
      this->SourceTime.Modified();
    }
  }

  // Draws lines that are not refined as chords, never as strips: the technique "auto".
  void SetChordLines(bool chords)
  {
    if (chords != this->ChordLines)
    {
      this->ChordLines = chords;
      this->SourceTime.Modified();
    }
  }

  // Colours by what happens to each primitive.
  void SetDebugView(bool debugView)
  {
    if (debugView != this->DebugView)
    {
      this->DebugView = debugView;
      this->SourceTime.Modified();
    }
  }

  // Triangles ray-tested behind every geometry stage, whatever the variant:
  // the technique "auto".
  void SetByRays(bool byRays)
  {
    if (byRays != this->ByRays)
    {
      this->ByRays = byRays;
      this->SourceTime.Modified();
    }
  }

  // The tables of a direction map; they outlive the frame.
  void SetTextures(wfv::DirectionTextures* textures) { this->Textures = textures; }

  // Those that this is one of.
  void SetStages(wfv::Stages* stages) { this->Stages = stages; }
  wfv::Stages* GetStages() const { return this->Stages; }

  // Of what has no primitives but a ray for each pixel.
  wfv::ShaderBuilder::Request MakeRayRequest() const;

  // What such a program needs to know, whatever it draws.
  void SetRayParameters(vtkShaderProgram* program);

  // NDC of the tile = NDC of the picture * first two + last two.
  const float* GetTile() const { return this->Tile; }

  // Draws of a frame, and how many of them are by the variant of SetUnrefined.
  int GetNumberOfDraws() const { return this->NumberOfDraws; }
  int GetNumberOfUnrefinedDraws() const { return this->NumberOfUnrefinedDraws; }
  void ResetNumberOfDraws() { this->NumberOfDraws = this->NumberOfUnrefinedDraws = 0; }

  // What the mapper's present primitives are drawn with.
  wfv::ShaderBuilder::Request MakeRequest(vtkAbstractMapper* mapper, vtkProp* prop) const;

  bool PreReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool PostReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop,
    vtkOpenGLVertexArrayObject* vao = nullptr) override;
  vtkMTimeType GetShaderStageMTime() override;
  void Render(const vtkRenderState*) override {}

protected:
  // VTK's volume mappers ask the last pass of a prop how many buffers they draw to.
  vtkWideFoVStage() { this->ActiveDrawBuffers = 1; }
  ~vtkWideFoVStage() override = default;

private:
  vtkWideFoVStage(const vtkWideFoVStage&) = delete;
  void operator=(const vtkWideFoVStage&) = delete;

  // The eye in the coordinates of the mapper; the diameter of tubes and of points drawn
  // as spheres; the width of lines.
  void SetPropParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop,
    const wfv::ProgramUses& uses) const;

  // Of volumes: the text (false: of something else), and where they may be in the picture.
  bool FinishVolume(vtkProp* prop, vtkAbstractMapper* mapper, std::string& vertex,
    std::string& geometry, std::string& fragment) const;
  void SetVolumeParameters(vtkShaderProgram* program, vtkProp* prop) const;

  // The text of the sky (false: of something else), and what its program is told.
  bool FinishSky(vtkAbstractMapper* mapper, vtkProp* prop, std::string& vertex,
    std::string& geometry, std::string& fragment);
  void SetSkyParameters(vtkShaderProgram* program, vtkProp* prop) const;

  // Of a program whose text is asked for.
  void NoteProgram(vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop) const;

  // What is the same for all props of a frame.
  void SetFrameParameters(vtkShaderProgram* program, const int viewport[4]);
  void SetSkirtUniform(vtkShaderProgram* program);

  // Says that a draw follows, which therefore may have the camera's matrices.
  void Announce() const;

  // Sets the stereo model, and how triangles are ray-tested, in a request whose primitives are
  // known.
  bool HasFp64Rays() const;
  void FinishTriangles(wfv::ShaderBuilder::Request& request) const;

  void NoteView(const wfv::View& view);

  // Texts that VTK has made, to the end; what cannot be drawn with then draws nothing.
  using Texts = wfv::ShaderMemory::Texts;
  void FinishTexts(const wfv::ShaderBuilder::Request& request, bool classifies,
    vtkAbstractMapper* mapper, Texts& texts);
  void Keep(const Texts& texts); // of those that were asked for last
  bool LeaveOutRefused(vtkAbstractMapper* mapper, vtkProp* prop, Texts& texts); // whether it did
  vtkObject* GetReporter();                                                     // of errors

  // Looks whether the bound framebuffer has several samples a pixel: before a frame, and for each
  // draw, where one of them has.
  void TakeSamples();
  void NoteSamples();

  // How the bound framebuffer is sampled, for the coverage of the pre-clip.
  static void SetSampleParameters(vtkShaderProgram* program);

  wfv::ShaderBuilder::Variant Variant = wfv::ShaderBuilder::Variant::Projected;
  wfv::ShaderBuilder::Variant Unrefined = wfv::ShaderBuilder::Variant::Projected;
  vtkRenderer* Renderer = nullptr;    // valid between SetView and the end of the frame
  vtkWideFoVCamera* Camera = nullptr; // the same
  // A tilt, a lens and a fade stay once one was there. Several samples: in a frame that begins with
  // them, or from the first draw on that has them.
  wfv::ShaderBuilder::ViewTraits Seen;
  vtkTimeStamp SourceTime;
  wfv::WfvView View{};
  wfv::DirectionTextures* Textures = nullptr;
  wfv::Stages* Stages = nullptr;
  float Viewport[4] = { 0, 0, 1, 1 };
  float Tile[4] = { 1, 1, 0, 0 };
  wfv::TilePixels Pixels;
  float Tolerance = 0.25f;
  int Headlights = 0;
  wfv::SteadyLights Lights;
  bool Clipless = false;
  bool ByRays = false;
  bool ChordLines = false;
  bool DebugView = false;
  int Runs = 1;
  bool Fp64 = false;
  int NumberOfDraws = 0;
  int NumberOfUnrefinedDraws = 0;
};
VTK_ABI_NAMESPACE_END

#endif

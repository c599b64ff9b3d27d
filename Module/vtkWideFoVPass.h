// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkWideFoVPass
 * @brief   draws any stock mapper in the non-planar view of a vtkWideFoVCamera
 *
 * Set it on a renderer whose active camera is a vtkWideFoVCamera. It adds the
 * projection to the shaders of every prop (polydata, composite data, glyphs):
 * behind the vertex stage where the prop meets no discontinuity of the projection,
 * in a geometry stage (the pre-clip) where it does. Of meshes of a vtkWideFoVPolyDataMapper,
 * and of blocks up to VTK 9.2, that is decided for clusters of triangles. With any other camera, or
 * with the projection "perspective", the picture is that of stock VTK, to the pixel, unless the
 * camera's ExactPerspective is on.
 *
 * Changing the projection rebuilds shader text and compiles a variant the first time
 * it is needed; changing a field of view, the tilt or the lens sets uniforms only.
 */

#ifndef vtkWideFoVPass_h
#define vtkWideFoVPass_h

#include "FrameStatistics.h" // For GetFrameStatistics
#include "vtkWideFoVAbi.h"   // For VTK_ABI_NAMESPACE_BEGIN

#include "vtkOpenGLRenderPass.h"
#include "vtkRenderingWideFoVModule.h" // For export macro

#include <array>  // For std::array
#include <memory> // For std::unique_ptr
#include <string> // For ShaderFolder

VTK_ABI_NAMESPACE_BEGIN
class vtkProp;
class vtkRenderer;
class vtkWideFoVCamera;

class VTKRENDERINGWIDEFOV_EXPORT vtkWideFoVPass : public vtkOpenGLRenderPass
{
public:
  ///@{
  /**
   * Standard methods of a VTK class.
   */
  static vtkWideFoVPass* New();
  vtkTypeMacro(vtkWideFoVPass, vtkOpenGLRenderPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  ///@}

  /**
   * What a primitive that the projection curves or parts is drawn with.
   */
  enum Techniques
  {
    AUTO = 0,   ///< triangles are split until their edges keep the tolerance, then projected; the
                ///< rest in the cheapest way that keeps it
    EXACT,      ///< every triangle by the ray of each pixel; the tolerance has no part in it
    TESSELLATE, ///< AUTO by its old name, with one warning; goes with the next release
    PRECLIP,    ///< clipped at the discontinuities, projected per vertex
    VERTEX      ///< projected per vertex, not clipped: for comparison only
  };

  ///@{
  /**
   * The technique (default AUTO), clamped to the numbers above.
   */
  virtual void SetTechnique(int technique);
  vtkGetMacro(Technique, int);
  void SetTechniqueToAuto() { this->SetTechnique(AUTO); }
  void SetTechniqueToExact() { this->SetTechnique(EXACT); }
  void SetTechniqueToTessellate() { this->SetTechnique(TESSELLATE); }
  void SetTechniqueToPreClip() { this->SetTechnique(PRECLIP); }
  void SetTechniqueToVertex() { this->SetTechnique(VERTEX); }
  ///@}

  /**
   * The name that a technique has on command lines, such as "auto"; nullptr where there is none of
   * that number.
   */
  static const char* GetTechniqueAsString(int technique);

  ///@{
  /**
   * Largest distance, in pixels, between a drawn edge and its true curve (default 0.25, clamped to
   * [0.001, 1e6]). With AUTO no pixel shows what is seen farther away, but for a face that is
   * hidden beside a silhouette, or where surfaces cross, by less than that. Under 0.05 AUTO draws
   * as EXACT.
   */
  vtkSetClampMacro(Tolerance, double, 0.001, 1e6);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /**
   * True where every triangle is drawn by the ray of each pixel: EXACT, and AUTO under 0.05 pixels.
   * Who asks for that of a perspective as well sets vtkWideFoVCamera::SetExactPerspective.
   */
  bool IsExact();
  static bool IsExactTechnique(int technique, double tolerance);
  ///@}

  ///@{
  /**
   * Colour every primitive by what happened to it (default off): let through as it is,
   * split at the seam, ray-tested because of a pole, exact, tessellated by level, projected by
   * the vertex stage. Documentation/debug-view.md shows the colours.
   */
  vtkSetMacro(DebugView, vtkTypeBool);
  vtkGetMacro(DebugView, vtkTypeBool);
  vtkBooleanMacro(DebugView, vtkTypeBool);
  ///@}

  /**
   * Where the tops of labels point: of point labels (vtkLabelPlacementMapper, vtkLabeledDataMapper)
   * and of vtkBillboardTextActor3D.
   */
  enum LabelUps
  {
    LABEL_UP_AUTOMATIC = 0, ///< to the zenith in a round map, to the picture's top in any other
    LABEL_UP_PICTURE,       ///< to the picture's top
    LABEL_UP_WORLD,         ///< to the renderer's EnvironmentUp
    LABEL_UP_ZENITH         ///< to what is up for the camera: the centre of a dome's picture
  };

  ///@{
  /**
   * The same (default LABEL_UP_AUTOMATIC).
   */
  vtkSetClampMacro(LabelUp, int, LABEL_UP_AUTOMATIC, LABEL_UP_ZENITH);
  vtkGetMacro(LabelUp, int);
  void SetLabelUpToAutomatic() { this->SetLabelUp(LABEL_UP_AUTOMATIC); }
  void SetLabelUpToPicture() { this->SetLabelUp(LABEL_UP_PICTURE); }
  void SetLabelUpToWorld() { this->SetLabelUp(LABEL_UP_WORLD); }
  void SetLabelUpToZenith() { this->SetLabelUp(LABEL_UP_ZENITH); }
  ///@}

  ///@{
  /**
   * Folder for the text of the shader programs that props are drawn with (default none: it is not
   * written). After a frame each program that is new has a file a stage there, as OpenGL has it,
   * named by a prop, what is drawn and how: prop0-triangles-cut.vert; programs.txt lists all. Files
   * that are there are overwritten. Where that fails there is one error, and no file more.
   */
  vtkSetStdStringFromCharMacro(ShaderFolder);
  vtkGetCharFromStdStringMacro(ShaderFolder);
  ///@}

  ///@{
  /**
   * Leave out what the view cannot show (default on): props, and clusters of triangles, that lie
   * outside the window or the clip spheres. The picture is the same without it, to the bit.
   */
  vtkSetMacro(Culling, vtkTypeBool);
  vtkGetMacro(Culling, vtkTypeBool);
  vtkBooleanMacro(Culling, vtkTypeBool);
  ///@}

  ///@{
  /**
   * Keep to the time that the window asks for by vtkRenderWindow::SetDesiredUpdateRate, as VTK's
   * level-of-detail props do (default off). While it asks for a frame a second or more, as an
   * interactor does that moves, and a frame took longer than its share, the next is relaxed by one
   * step more, as long as steps save time. A frame that has more time is as without. Each frame is
   * then waited for, to know what it took.
   */
  vtkSetMacro(KeepUpdateRate, vtkTypeBool);
  vtkGetMacro(KeepUpdateRate, vtkTypeBool);
  vtkBooleanMacro(KeepUpdateRate, vtkTypeBool);
  ///@}

  /**
   * How much a frame is relaxed. The smaller ones have one sample a pixel too, and are enlarged.
   * The tolerance stays that of the window's pixels: a larger one makes no frame cheaper.
   */
  enum Relaxations
  {
    NOT_RELAXED = 0, ///< as a frame that stands
    ONE_SAMPLE,      ///< with one sample a pixel
    HALF_SIZE,       ///< with half as many pixels on each side,
    THIRD_SIZE,      ///< a third,
    QUARTER_SIZE     ///< a quarter
  };

  ///@{
  /**
   * The least and the most that interactive frames are relaxed (default 0, 4). Alike they
   * fix it, whatever frames take. Both are clamped to the Relaxations, the most to the least.
   */
  void SetRelaxationRange(int least, int most);
  void SetRelaxationRange(const int range[2]);
  vtkGetVector2Macro(RelaxationRange, int);
  ///@}

  /**
   * How much the last frame was relaxed: Relaxations.
   */
  vtkGetMacro(Relaxation, int);

  ///@{
  /**
   * The pass that draws the props; nullptr (the default) draws as a renderer without
   * passes does: opaque, translucent, volumetric, overlay.
   */
  virtual void SetDelegatePass(vtkRenderPass* pass);
  vtkRenderPass* GetDelegatePass();
  ///@}

  /**
   * What the last frame drew and left out, and what it had to do anew.
   */
  const wfv::FrameStatistics& GetFrameStatistics() { return this->Figures; }

  ///@{
  /**
   * The same one by one: structures have no wrapping.
   */
  int GetNumberOfDrawnProps() { return this->Figures.DrawnProps; }
  int GetNumberOfCulledProps() { return this->Figures.CulledProps; }
  int GetNumberOfProjectedDraws() { return this->Figures.ProjectedDraws; }
  int GetNumberOfPreClipDraws() { return this->Figures.PreClipDraws; }
  int GetNumberOfExactDraws() { return this->Figures.ExactDraws; }
  int GetNumberOfTessellateDraws() { return this->Figures.TessellateDraws; }
  int GetNumberOfClusters() { return this->Figures.Clusters; }
  int GetNumberOfCulledClusters() { return this->Figures.CulledClusters; }
  vtkIdType GetNumberOfTriangles() { return this->Figures.Triangles; }
  vtkIdType GetNumberOfCulledTriangles() { return this->Figures.CulledTriangles; }
  vtkIdType GetNumberOfProjectedTriangles() { return this->Figures.ProjectedTriangles; }
  int GetNumberOfChosenProps() { return this->Figures.ChosenProps; }
  int GetNumberOfClassifiedMeshes() { return this->Figures.ClassifiedMeshes; }
  int GetNumberOfMadePrograms() { return this->Figures.MadePrograms; }
  double GetShaderTime() { return this->Figures.ShaderTime; }
  double GetClusterTime() { return this->Figures.ClusterTime; }
  ///@}

  /**
   * GetNumberOfProjectedDraws by its old name, for one release.
   */
  int GetNumberOfPlainDraws();

  /**
   * These figures in words, a line each: of the last frame, or, while one is drawn, of what it
   * drew so far. vtkWideFoVStatisticsActor puts them on the picture.
   */
  std::string GetStatistics();

  ///@{
  /**
   * Of vtkRenderPass: draws the props of the state; gives back what a context has of the pass, and
   * of the delegate.
   */
  void Render(const vtkRenderState* s) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  ///@}

protected:
  vtkWideFoVPass();
  ~vtkWideFoVPass() override;

  int Technique = AUTO;
  double Tolerance = 0.25;
  vtkTypeBool DebugView = 0;
  int LabelUp = LABEL_UP_AUTOMATIC;
  std::string ShaderFolder;
  vtkTypeBool Culling = 1;
  vtkTypeBool KeepUpdateRate = 0;
  int Relaxation = NOT_RELAXED;
  int RelaxationRange[2] = { NOT_RELAXED, QUARTER_SIZE };
  wfv::FrameStatistics Figures;
  bool Draws = false;      // a wide frame, just now
  bool InDelegate = false; // that is what draws it

private:
  vtkWideFoVPass(const vtkWideFoVPass&) = delete;
  void operator=(const vtkWideFoVPass&) = delete;

  // Draws the props by the delegate, or as a renderer without passes does.
  void DrawDelegate(const vtkRenderState* s);

  // Moves the props that are not seen behind the others; returns how many are left. selects: the
  // frame is for picking.
  int Cull(vtkProp** props, bool selects);

  // Draws these props, of those of the state, with the stages that they need.
  void DrawProps(const vtkRenderState* s, vtkProp** props, int count);

  // With any other, which stock VTK draws; camera may be nullptr.
  void DrawFlat(const vtkRenderState* s, vtkWideFoVCamera* camera);

  // With the renderer's active camera.
  void RenderActive(const vtkRenderState* s);

  // The size of what is drawn to, where that is not the window; sets the border of the picture in
  // it.
  bool FindFramebuffer(const vtkRenderState* s, int size[2]);

  // Tells the camera of the frame, once its props are known.
  void BeginFrame(const vtkRenderState* s, vtkWideFoVCamera* camera);

  // What is drawn upon all others: labels that are placed in the picture, texts that stand in it.
  void DrawLabels(vtkRenderer* renderer);

  // With a camera that is wide.
  void RenderWide(const vtkRenderState* s, vtkWideFoVCamera* camera);

  void ResetCounts(int props);
  void TakeCounts();

  // How much this frame is relaxed, from the time that the last one took.
  void FindRelaxation(const vtkRenderState* s);

  // Which steps of it make a difference.
  std::array<bool, QUARTER_SIZE + 1> FindRelaxations(bool small, bool samples) const;

  // Of the pixels that this frame is drawn with.
  double FindTolerance() const;

  // Tells them of the view and of what this pass was told.
  void BeginStages(vtkRenderer* renderer, vtkWideFoVCamera* camera);

  // What is new, into ShaderFolder.
  void WriteShaders();

  // Draws so many props, the first ones, where the frame is shown or smaller.
  void DrawSeen(const vtkRenderState* s, int seen);

  struct Internals;
  std::unique_ptr<Internals> Internal;
};
VTK_ABI_NAMESPACE_END

#endif

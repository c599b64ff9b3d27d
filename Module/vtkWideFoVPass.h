// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkWideFoVPass
 * @brief   draws any stock mapper in the non-planar view of a vtkWideFoVCamera
 *
 * Set it on a renderer whose active camera is a vtkWideFoVCamera. It adds the
 * projection to the shaders of every prop (polydata, composite data, glyphs):
 * behind the vertex stage where the prop meets no discontinuity of the projection,
 * in a geometry stage (the pre-clip) where it does. With any other camera, or with
 * the projection "perspective", the picture is that of stock VTK, to the pixel, unless the
 * camera's ExactPerspective is on.
 *
 * Changing the projection rebuilds shader text and compiles a variant the first time
 * it is needed; changing a field of view, the tilt or the lens sets uniforms only.
 */

#ifndef vtkWideFoVPass_h
#define vtkWideFoVPass_h

#include "vtkOpenGLRenderPass.h"
#include "vtkRenderingWideFoVModule.h" // For export macro
#include "vtkWideFoVAbi.h"             // For VTK_ABI_NAMESPACE_BEGIN

#include <memory> // For std::unique_ptr
#include <string> // For GetStatistics

VTK_ABI_NAMESPACE_BEGIN
class vtkProp;
class vtkRenderer;
class vtkWideFoVCamera;

class VTKRENDERINGWIDEFOV_EXPORT vtkWideFoVPass : public vtkOpenGLRenderPass
{
public:
  static vtkWideFoVPass* New();
  vtkTypeMacro(vtkWideFoVPass, vtkOpenGLRenderPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * What a primitive that the projection bends or tears is drawn with.
   */
  enum Techniques
  {
    AUTO = 0,   ///< per prop the cheapest that keeps the tolerance: the vertex stage alone, or
                ///< every triangle by the ray of each pixel
    EXACT,      ///< every triangle by the ray of each pixel; the tolerance has no part in it
    TESSELLATE, ///< triangles of a vtkWideFoVPolyDataMapper are tessellated to the tolerance,
                ///< the pieces by rays; of other mappers, triangles by rays and the rest as
                ///< PRECLIP. An OpenGL without tessellation shaders: a warning, and AUTO
    PRECLIP,    ///< clipped at the discontinuities, projected per vertex
    VERTEX      ///< projected per vertex, not clipped: for comparison only
  };

  ///@{
  /**
   * The technique (default AUTO).
   */
  vtkSetClampMacro(Technique, int, AUTO, VERTEX);
  vtkGetMacro(Technique, int);
  void SetTechniqueToAuto() { this->SetTechnique(AUTO); }
  void SetTechniqueToExact() { this->SetTechnique(EXACT); }
  void SetTechniqueToTessellate() { this->SetTechnique(TESSELLATE); }
  void SetTechniqueToPreClip() { this->SetTechnique(PRECLIP); }
  void SetTechniqueToVertex() { this->SetTechnique(VERTEX); }
  ///@}

  ///@{
  /**
   * Largest distance, in pixels, between a drawn edge and its true curve where the
   * pre-clip decides between a chord and the curve itself (default 0.25, clamped to
   * [0.001, 1e6]).
   */
  vtkSetClampMacro(Tolerance, double, 0.001, 1e6);
  vtkGetMacro(Tolerance, double);
  ///@}

  /**
   * True where every triangle is drawn by the ray of each pixel: EXACT, and AUTO under 0.05 pixels.
   * Who asks for that of a perspective as well sets vtkWideFoVCamera::SetExactPerspective.
   */
  bool IsExact();
  static bool IsExactTechnique(int technique, double tolerance);

  ///@{
  /**
   * Colour every primitive by what happened to it (default off): let through as it is,
   * split at the seam, covered because of a pole, exact, tessellated by level, of a prop
   * without a geometry stage. Documentation/debug-view.md shows the colours.
   */
  vtkSetMacro(DebugView, vtkTypeBool);
  vtkGetMacro(DebugView, vtkTypeBool);
  vtkBooleanMacro(DebugView, vtkTypeBool);
  ///@}

  ///@{
  /**
   * Leave out what the view cannot show (default on): props, and runs of triangles of a
   * vtkWideFoVPolyDataMapper, that lie outside the window or the clip spheres. The picture is
   * the same without it, to the bit.
   */
  vtkSetMacro(Culling, vtkTypeBool);
  vtkGetMacro(Culling, vtkTypeBool);
  vtkBooleanMacro(Culling, vtkTypeBool);
  ///@}

  ///@{
  /**
   * Leave out the triangles of large meshes that stand behind everything that is seen where they
   * are (default on), once a view and what is in it have stood for some ten frames (with
   * SortWhileMoving, for one), until something of it changes. The picture is the same to the bit.
   * Not with a delegate pass, with several samples a pixel, with props among those before of which
   * there is no telling when they change (others than plain actors), or where the depths of a frame
   * are not its own. Only with Culling.
   */
  vtkSetMacro(OcclusionCulling, vtkTypeBool);
  vtkGetMacro(OcclusionCulling, vtkTypeBool);
  vtkBooleanMacro(OcclusionCulling, vtkTypeBool);
  ///@}

  ///@{
  /**
   * Sort the triangles of large meshes one by one in every frame, even while the view or the data
   * change from each to the next (default off). That takes longer than it saves in some ten frames,
   * so a view is sorted in haste until it has been drawn as often. The picture is the same, and
   * as exact, but for two things: beside the fold of a surface a pixel may, most rarely, show the
   * face that is hidden by the other; and while the window asks for a frame a second or more by
   * vtkRenderWindow::SetDesiredUpdateRate, as an interactor does that moves, triangles are
   * drawn by their chords where these are within the tolerance of their edges, and beside an
   * outline a pixel may show a face that is hidden there.
   */
  vtkSetMacro(SortWhileMoving, vtkTypeBool);
  vtkGetMacro(SortWhileMoving, vtkTypeBool);
  vtkBooleanMacro(SortWhileMoving, vtkTypeBool);
  ///@}

  ///@{
  /**
   * Keep to the time that the window asks for by vtkRenderWindow::SetDesiredUpdateRate, as VTK's
   * level-of-detail props do (default off). While it asks for a frame a second or more, as an
   * interactor does that moves, and a frame took longer than its share, the next is relaxed:
   * triangles are clipped and drawn by their chords, to a larger tolerance. A frame that has more
   * time is as without. GetRelaxation says by how much the last frame was relaxed: 0 not at all,
   * 1 and 2 to a tolerance of at least one and at least four pixels.
   */
  vtkSetMacro(KeepUpdateRate, vtkTypeBool);
  vtkGetMacro(KeepUpdateRate, vtkTypeBool);
  vtkBooleanMacro(KeepUpdateRate, vtkTypeBool);
  vtkGetMacro(Relaxation, int);
  ///@}

  /**
   * Whether both eyes are drawn in one traversal of the props.
   */
  enum EyesAtOnceChoices
  {
    AUTOMATIC = 0, ///< where a driver is known to be faster so: none is
    ALWAYS,        ///< wherever it can be
    NEVER          ///< two traversals, VTK's own
  };

  ///@{
  /**
   * Draw opaque triangles for both eyes at once, while VTK's window draws the left one (default
   * NEVER: on no driver measured so far is it faster), and show the right one what is its own when
   * its turn comes; what else there is is drawn in each eye's turn. The picture is the same, to the
   * bit. That can be for the stereo models whose eyes differ by their side alone, for every stereo
   * type that shows both eyes, in a renderer that erases its background and has no delegate pass
   * here.
   */
  vtkSetClampMacro(EyesAtOnce, int, AUTOMATIC, NEVER);
  vtkGetMacro(EyesAtOnce, int);
  ///@}

  ///@{
  /**
   * The pass that draws the props; nullptr (the default) draws as a renderer without
   * passes does: opaque, translucent, volumetric, overlay.
   */
  virtual void SetDelegatePass(vtkRenderPass* pass);
  vtkRenderPass* GetDelegatePass();
  ///@}

  ///@{
  /**
   * What the last frame drew: draw calls without the geometry stage, with the pre-clip,
   * with everything exact, and tessellated.
   */
  vtkGetMacro(NumberOfPlainDraws, int);
  vtkGetMacro(NumberOfPreClipDraws, int);
  vtkGetMacro(NumberOfExactDraws, int);
  vtkGetMacro(NumberOfTessellateDraws, int);
  ///@}

  ///@{
  /**
   * What the last frame left out: visible props that it drew and did not; runs of 128 triangles
   * of vtkWideFoVPolyDataMapper, all of them and those that were not drawn (a run counts once a
   * draw, and meshes of less than 256 triangles have none).
   */
  vtkGetMacro(NumberOfDrawnProps, int);
  vtkGetMacro(NumberOfCulledProps, int);
  vtkGetMacro(NumberOfClusters, int);
  vtkGetMacro(NumberOfCulledClusters, int);
  ///@}

  /**
   * Of the props that the last frame drew, those that were drawn for both eyes at once: in the left
   * eye's turn then, and not again in the right one's, whose draws and runs are those of the
   * others.
   */
  vtkGetMacro(NumberOfSharedProps, int);

  /**
   * Of the props that the last frame drew, those so far away that both eyes see them alike: they
   * are drawn as without stereo, in each eye's turn.
   */
  vtkGetMacro(NumberOfFarProps, int);

  ///@{
  /**
   * The same by triangles: those of the meshes that have runs, and those of them that were not
   * drawn, for their run is outside the view, they lie between the samples of the picture or are
   * hidden: how many for that alone. What a geometry stage lets fall is not known here.
   */
  vtkGetMacro(NumberOfTriangles, vtkIdType);
  vtkGetMacro(NumberOfCulledTriangles, vtkIdType);
  vtkGetMacro(NumberOfHiddenTriangles, vtkIdType);
  ///@}

  ///@{
  /**
   * What the last frame had to do that could not be kept from the one before: actors whose stage
   * was chosen, meshes whose triangles were sorted. 0 where nothing has changed.
   */
  vtkGetMacro(NumberOfChosenProps, int);
  vtkGetMacro(NumberOfSortedMeshes, int);
  ///@}

  ///@{
  /**
   * Shader programs that were made so far, in all frames, and the seconds that it took to write
   * their text and to make them: each when it is first needed. Some drivers finish a program only
   * when it is first drawn with; that is not in ShaderTime.
   */
  vtkGetMacro(NumberOfMadePrograms, int);
  vtkGetMacro(ShaderTime, double);
  ///@}

  /**
   * These figures in words, a line each: of the last frame, or, while one is drawn, of what it
   * drew so far. vtkWideFoVStatisticsActor puts them on the picture.
   */
  std::string GetStatistics();

  void Render(const vtkRenderState* s) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkWideFoVPass();
  ~vtkWideFoVPass() override;

  int Technique = AUTO;
  double Tolerance = 0.25;
  vtkTypeBool DebugView = 0;
  int NumberOfPlainDraws = 0;
  int NumberOfPreClipDraws = 0;
  int NumberOfExactDraws = 0;
  int NumberOfTessellateDraws = 0;
  vtkTypeBool Culling = 1;
  vtkTypeBool OcclusionCulling = 1;
  vtkTypeBool SortWhileMoving = 0;
  vtkTypeBool KeepUpdateRate = 0;
  int Relaxation = 0;
  int EyesAtOnce = NEVER;
  int NumberOfSharedProps = 0;
  int NumberOfFarProps = 0;
  int NumberOfDrawnProps = 0;
  int NumberOfCulledProps = 0;
  int NumberOfClusters = 0;
  int NumberOfCulledClusters = 0;
  vtkIdType NumberOfTriangles = 0;
  vtkIdType NumberOfCulledTriangles = 0;
  vtkIdType NumberOfHiddenTriangles = 0;
  int NumberOfChosenProps = 0;
  int NumberOfSortedMeshes = 0;
  int NumberOfMadePrograms = 0;
  double ShaderTime = 0;
  bool Draws = false; // a wide frame, just now

private:
  vtkWideFoVPass(const vtkWideFoVPass&) = delete;
  void operator=(const vtkWideFoVPass&) = delete;

  // Draws the props by the delegate, or as a renderer without passes does.
  void DrawDelegate(const vtkRenderState* s);

  // Moves the props that are not seen behind the others; returns how many are left.
  int Cull(vtkProp** props);

  // Draws these props, of those of the state, with the stages that they need.
  void DrawProps(const vtkRenderState* s, vtkProp** props, int count);

  // Moves the props that may be drawn for both eyes at once before the others.
  void GatherShared(vtkProp** props, int count);

  // Finds out whether they are, in this frame.
  void BeginShared(const vtkRenderState* s, vtkProp** props);

  // Nothing speaks against it.
  bool MayShare(const vtkRenderState* s, vtkProp** props);

  // Draws or shows them, then the others of the renderer.
  void DrawShared(const vtkRenderState* s);

  // Finds out whether what stands before what is as it was in the last frame.
  void BeginHidden(const vtkRenderState* s, vtkProp** props);

  // Whether anything may be left out for it.
  bool MayHide(const vtkRenderState* s, vtkProp** props);

  // With a camera that is wide.
  void RenderWide(const vtkRenderState* s, vtkWideFoVCamera* camera);

  void ResetCounts(int props);
  void TakeCounts();

  // How much the next frame is relaxed, from the time that the last one took.
  void FindRelaxation(vtkRenderer* renderer);

  struct Internals;
  std::unique_ptr<Internals> Internal;
};
VTK_ABI_NAMESPACE_END

#endif

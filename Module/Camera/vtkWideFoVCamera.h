// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkWideFoVCamera
 * @brief   a camera whose projection may be non-planar, up to 360 degrees
 *
 * Position, focal point and view up are those of vtkCamera; what differs is how view coordinates
 * (x right, y up, looking down -z) become a picture. The camera only describes the view:
 * vtkWideFoVPass (any stock mapper) or vtkWideFoVPolyDataMapper draw with it.
 *
 * With the projection "perspective" it is an ordinary perspective camera with a horizontal and a
 * vertical field of view, and every stock part of VTK serves it. All angles are in degrees, all
 * distances in scene units.
 */

#ifndef vtkWideFoVCamera_h
#define vtkWideFoVCamera_h

#include "vtkWideFoVAbi.h" // For VTK_ABI_NAMESPACE_BEGIN

#include "vtkOpenGLCamera.h"
#include "vtkRenderingWideFoVModule.h" // For export macro

#include <memory> // For std::unique_ptr
#include <string> // For std::string

namespace wfv
{
class DirectionMap;
class FlatQuestions;
class View;
struct Projection;
struct StereoModel;
struct StereoOptions;
struct ViewRay;
}

VTK_ABI_NAMESPACE_BEGIN
class vtkImageData;

class VTKRENDERINGWIDEFOV_EXPORT vtkWideFoVCamera : public vtkOpenGLCamera
{
public:
  ///@{
  /// Standard methods of a VTK class.
  static vtkWideFoVCamera* New();
  vtkAbstractTypeMacro(vtkWideFoVCamera, vtkOpenGLCamera);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  ///@}

  ///@{
  /// The projection, by name (default "equirectangular"). An unknown name is refused with an error
  /// that lists the known ones. Fields of view outside the range of the new projection are clamped
  /// to it.
  virtual void SetProjection(const char* name);
  virtual const char* GetProjection();
  void SetProjectionToEquirectangular() { this->SetProjection("equirectangular"); }
  void SetProjectionToCylindricalEqualArea() { this->SetProjection("cylindrical-equal-area"); }
  void SetProjectionToMiller() { this->SetProjection("miller"); }
  void SetProjectionToMercator() { this->SetProjection("mercator"); }
  void SetProjectionToCentralCylindrical() { this->SetProjection("central-cylindrical"); }
  void SetProjectionToPanini() { this->SetProjection("panini"); }
  void SetProjectionToHammer() { this->SetProjection("hammer"); }
  void SetProjectionToAitoff() { this->SetProjection("aitoff"); }
  void SetProjectionToWinkelTripel() { this->SetProjection("winkel-tripel"); }
  void SetProjectionToMollweide() { this->SetProjection("mollweide"); }
  void SetProjectionToSinusoidal() { this->SetProjection("sinusoidal"); }
  void SetProjectionToEckertIV() { this->SetProjection("eckert-iv"); }
  void SetProjectionToAzimuthalEquidistant() { this->SetProjection("azimuthal-equidistant"); }
  void SetProjectionToAzimuthalEqualArea() { this->SetProjection("azimuthal-equal-area"); }
  void SetProjectionToStereographic() { this->SetProjection("stereographic"); }
  void SetProjectionToOrthographic() { this->SetProjection("orthographic"); }
  void SetProjectionToGnomonic() { this->SetProjection("gnomonic"); }
  void SetProjectionToBrownConrady() { this->SetProjection("brown-conrady"); }
  void SetProjectionToEquiAngularCubemap() { this->SetProjection("equi-angular-cubemap"); }
  void SetProjectionToDirectionMap() { this->SetProjection("direction-map"); }
  void SetProjectionToPerspective() { this->SetProjection("perspective"); }
  ///@}

  ///@{
  /// The projections there are.
  static int GetNumberOfProjections();
  static const char* GetProjectionName(int index);
  ///@}

  ///@{
  /// Fields of view in degrees, above 0 (defaults 360 and 180), clamped with a warning to the range
  /// of the projection. A round projection (azimuthal) uses the horizontal one alone.
  virtual void SetHorizontalFieldOfView(double degrees);
  virtual double GetHorizontalFieldOfView();
  virtual void SetVerticalFieldOfView(double degrees);
  virtual double GetVerticalFieldOfView();
  ///@}

  /// The field of view of a round projection: the full angle across the circle.
  virtual void SetFieldOfView(double degrees);

  ///@{
  /// vtkCamera's words for the field of view. The view angle is the vertical field of view,
  /// degrees; the horizontal one of round projections, or where UseHorizontalViewAngle says so. To
  /// set it changes both fields by one factor (of a perspective: the sides of the picture), and to
  /// zoom divides it. These are not virtual in vtkCamera: what is set through a pointer to
  /// vtkCamera changes nothing, with one warning. Between frames GetViewAngle is vtkCamera's own,
  /// 30: what places a camera by it, as ResetCamera does, places a wide one as such a perspective.
  void SetViewAngle(double degrees);
  void Zoom(double factor);
  ///@}

  ///@{
  /// How far the axis is raised from the direction of view towards view up, degrees (default 0; 90
  /// puts the zenith at the centre of a dome picture). Clamped to [-180, 180].
  virtual void SetTilt(double degrees);
  virtual double GetTilt();
  ///@}

  ///@{
  /// Lens polynomial: r = c1 t + c2 t^2 + .. + c9 t^9, r = 1 at the rim of the picture (but see
  /// SetMeasuredPicture); t is the angle from the axis, radians, or with "brown-conrady" its
  /// tangent. What does not grow up to half the field of view is refused with an error, and the old
  /// one stays. ClearLens() (the default): the ideal lens, r = t / (fov/2) of a fisheye.
  virtual bool SetLens(double c1, double c2, double c3, double c4, double c5);
  virtual void ClearLens();
  virtual void GetLens(double coefficients[5]);
  virtual bool SetLensCoefficients(const double coefficients[9]);
  virtual void GetLensCoefficients(double coefficients[9]);
  ///@}

  ///@{
  /// Where a round projection lies in a picture, as cameras are calibrated: its size, the place of
  /// the axis and the focal lengths (of the radius 1 of the lens), pixels from the upper left. A
  /// window shows it as large as it fits. By default the rim touches the borders of the window.
  virtual bool SetMeasuredPicture(const double size[2], const double at[2], const double focal[2]);
  virtual void ClearMeasuredPicture();
  virtual void GetMeasuredPicture(double size[2], double at[2], double focal[2]);
  ///@}

  ///@{
  /// What the projection "direction-map" shows: the direction of each pixel, as a picture of at
  /// least 2 x 2 pixels of three numbers (the active scalars; view coordinates: x right, y up, z
  /// behind; unit vectors, or 0, 0, 0 for a pixel that shows nothing). The camera keeps no
  /// reference to it. The ray of a picture of the same size is the given one at each pixel's
  /// centre; between centres, and at other sizes, directions are interpolated within what hangs
  /// together. Anything else is refused with an error, and the old map stays. nullptr (the
  /// default): no pixel shows anything.
  virtual bool SetDirectionMap(vtkImageData* directions);
  virtual bool HasDirectionMap();
  ///@}

  ///@{
  /// Radii of the near and far clip spheres, scene units, 0 < near < far (anything else is refused
  /// with an error). Setting them switches AutomaticClipRadii off.
  virtual void SetClipRadii(double nearRadius, double farRadius);
  virtual void GetClipRadii(double radii[2]);
  double GetNearClipRadius();
  double GetFarClipRadius();
  ///@}

  ///@{
  /// Derive the clip spheres from the bounds of the visible props before each frame (default on).
  /// If the eye is in them, the near radius is 1e-6 of the far one (1e-4 with REVERSED and where
  /// stock VTK draws); LOGARITHMIC begins before what is nearer, others warn once of it.
  vtkSetMacro(AutomaticClipRadii, vtkTypeBool);
  vtkGetMacro(AutomaticClipRadii, vtkTypeBool);
  vtkBooleanMacro(AutomaticClipRadii, vtkTypeBool);
  ///@}

  /// Set the clip radii so that what the view may show of the bounds (xmin, xmax, .., zmax; world)
  /// lies between them. Uninitialized bounds change nothing.
  virtual void ResetClipRadii(const double bounds[6]);

  /// How depth grows with the distance rho from the eye, from the near to the far sphere. All of
  /// them grow, so that whatever of VTK compares, clears or reads depth goes on working; reversing
  /// the comparison itself is not possible in the stock passes, which set it themselves.
  enum DepthMappings
  {
    LINEAR = 0,  ///< (rho - near) / (far - near): the same step everywhere
    LOGARITHMIC, ///< log(rho / near) / log(far / near): steps in proportion to the distance
    REVERSED     ///< linear in 1 / rho, as the depth of a perspective: finest nearby
  };

  ///@{
  /// The depth mapping (default LINEAR). Of a perspective that stock VTK draws it is stock VTK's.
  /// The mappings other than LINEAR write depth in the fragment stage.
  virtual void SetDepthMapping(int mapping);
  virtual int GetDepthMapping();
  void SetDepthMappingToLinear() { this->SetDepthMapping(LINEAR); }
  void SetDepthMappingToLogarithmic() { this->SetDepthMapping(LOGARITHMIC); }
  void SetDepthMappingToReversed() { this->SetDepthMapping(REVERSED); }
  ///@}

  ///@{
  /// The stereo model, by name (default "mono": both eyes see the same). What differs between the
  /// eyes of a window in stereo mode, whatever its stereo type: "omnidirectional" (eyes on a
  /// circle, that turn with every column of the picture), "warped" (the picture with its depth is
  /// an object between the eyes), both for wide projections, and "offaxis", for the projection
  /// "perspective". An unknown name is refused with an error that lists the known ones. With a
  /// projection that it is not made for, a model does nothing.
  virtual void SetStereoModel(const char* name);
  virtual const char* GetStereoModel();
  void SetStereoModelToMono() { this->SetStereoModel("mono"); }
  void SetStereoModelToWarped() { this->SetStereoModel("warped"); }
  void SetStereoModelToOmnidirectional() { this->SetStereoModel("omnidirectional"); }
  void SetStereoModelToOffAxis() { this->SetStereoModel("offaxis"); }
  static int GetNumberOfStereoModels();
  static const char* GetStereoModelName(int index);
  ///@}

  ///@{
  /// Omnidirectional: the distance between the eyes, scene units, at least 0 (default 0.065,
  /// people's in metres). What is nearer to the circle's axis than half of it is not seen.
  virtual void SetInterpupillaryDistance(double distance);
  virtual double GetInterpupillaryDistance();
  void SetEyeSeparation(double distance) override; ///< vtkCamera's word for it
  double GetEyeSeparation() override;
  ///@}

  ///@{
  /// Omnidirectional: latitudes in degrees, 0 to 90, between which the eyes' distance shrinks
  /// smoothly to nothing, for there a circle's two eyes turn about (default: off, full distance
  /// everywhere). The second is at least the first; anything else is refused with an error.
  virtual void SetPoleFade(double start, double end);
  virtual void ClearPoleFade() { this->SetPoleFade(0, 0); }
  virtual void GetPoleFade(double latitudes[2]);
  ///@}

  ///@{
  /// Omnidirectional: the level distance, scene units, at which points have zero parallax all round
  /// (default 0, which is infinitely far away). Each eye's view is turned about the vertical, so
  /// its view transform is its own. A negative or infinite distance is refused with an error.
  virtual void SetCircleConvergence(double distance);
  virtual double GetCircleConvergence();
  ///@}

  ///@{
  /// Warped: the distance between the eyes (NDC, default 0.5, clamped to [0, 10]), the distance of
  /// the viewer from the plane of zero parallax (NDC, default 5) and that plane (NDC depth, default
  /// -0.8, clamped to [-1, 1]). The viewer is in front of the whole cube: a distance not above 1 +
  /// offset is refused with an error.
  virtual void SetWarpedStereo(double iod, double distance, double offset);
  virtual void GetWarpedStereo(double values[3]);
  ///@}

  /// Where the viewer is to the right of and above the cube's axis (NDC, default 0, 0), for tracked
  /// heads. What is not finite is refused with an error.
  virtual void SetWarpedViewer(double x, double y);

  ///@{
  /// Off-axis: the parallax of what is infinitely far away, as a fraction of the picture's width
  /// (default 0.03, clamped to [0, 0.5]), and the distance that has none, scene units, above 0
  /// (default 10; anything else is refused with an error).
  virtual void SetSeparation(double fraction);
  virtual double GetSeparation();
  virtual void SetConvergence(double distance);
  virtual double GetConvergence();
  ///@}

  ///@{
  /// Comfort of the off-axis model. Parallax of a point at this distance ahead (above 0), per cent
  /// of the picture's width, positive behind the screen; distances between which content belongs
  /// (half the convergence and a hundred times it); the angle in degrees under which a parallax is
  /// seen on a screen of this width from this distance; the largest separation with which no eyes
  /// have to diverge on a screen of this width (both in the same unit; people's eyes are 0.065 m
  /// apart). Arguments that are not above 0 give 0.
  double GetParallax(double distance);
  void GetDepthBudget(double range[2]);
  static double GetParallaxAngle(double percent, double screenWidth, double viewerDistance);
  static double GetLargestSeparation(double screenWidth, double eyeDistance);
  ///@}

  /// Sets where nothing has parallax from the depths of the last frame that the renderer drew with
  /// this camera: the convergence of "offaxis" to the median of the distances, within the budget of
  /// what is seen (ConvergenceFor in Stereo/Comfort.h), the offset of "warped" to the median depth.
  /// False, and nothing changes, with another model or where nothing was drawn.
  bool ConvergeOnDepth(vtkRenderer* renderer);

  /// One of two eyes, or the place between them.
  enum EyeType
  {
    LEFT_EYE = -1,
    MIDDLE_EYE = 0,
    RIGHT_EYE = 1
  };

  /// Which eye the camera is now, an EyeType: MIDDLE_EYE where the window that last drew with it is
  /// not in stereo mode.
  int GetCurrentEye();

  /// How far the eyes of the stereo model are from the camera's position, scene units: 0 where
  /// they are there.
  virtual double GetBaselineRadius();

  /// Its old name, for one release.
  double GetEyeReach();

  ///@{
  /// Whether the techniques draw the projection "perspective" as they do all others (default off:
  /// stock VTK draws it). Where its corners are more than 80 degrees from its axis, the axis is not
  /// in the middle, or there is a stereo model, stock VTK does all the same.
  vtkSetMacro(ExactPerspective, vtkTypeBool);
  vtkGetMacro(ExactPerspective, vtkTypeBool);
  ///@}

  /// True unless the projection is a "perspective" for which stock VTK serves.
  bool IsWide();

  ///@{
  /// World coordinates to NDC (x, y, depth in [-1, 1]) and back, in a viewport of the given aspect
  /// (width / height). The return value tells whether the point is in the picture (WorldToNDC), or
  /// the map has a direction there (NDCToWorld).
  bool WorldToNDC(const double world[3], double aspect, double ndc[3]);
  bool NDCToWorld(const double ndc[3], double aspect, double world[3]);
  ///@}

  /// The ray through a point of the picture: where it starts and its unit direction, in world
  /// coordinates. False where the map has no direction.
  bool NDCToRay(const double ndc[2], double aspect, double origin[3], double direction[3]);

#ifndef __VTK_WRAP__
  /// Where the present eye of a perspective is, view coordinates; 0, 0, 0 without stereo and of
  /// wide projections, whose rays begin where NDCToRay says.
  void GetPerspectiveEye(double aspect, float eye[3]);

  /// The same as SetDirectionMap of a picture, with tables that several cameras may share.
  void SetDirectionMap(const std::shared_ptr<const wfv::DirectionMap>& map);

  /// Of stages: what asks for the matrices next has one. Whatever else asks for them would draw a
  /// flat picture into the view; it is given some by which nothing is seen, and is counted.
  void ExpectStage();

  /// How many times since the last call something without a stage asked for the matrices.
  int TakeFlatDraws();

  ///@{
  /// What VTK's own pickers and handles ask of a camera: they are told what makes them find and
  /// move what is seen. To all others these are vtkCamera's own.
  void GetPosition(double position[3]) override;
  void GetFocalPoint(double point[3]) override;
  void GetDirectionOfProjection(double direction[3]) override;
  double* GetClippingRange() override;
  using Superclass::GetClippingRange, Superclass::GetDirectionOfProjection;
  using Superclass::GetFocalPoint, Superclass::GetPosition;
  wfv::FlatQuestions& GetFlatQuestions();
  ///@}

  /// Whether the view plane has no normal: for labels that ask it what is behind it.
  void SetNothingBehind(bool nothing);

  /// The view as two functions, in view coordinates (see Projections/Projection.h). Valid until the
  /// camera is changed or another aspect is asked for.
  const wfv::View& GetView(double aspect);

  /// The projection that was set, as the registry has it.
  const wfv::Projection& GetProjectionDefinition();
#endif

  /// Before a frame is drawn: updates the automatic clip spheres from the visible props.
  /// Render and the pass call it.
  virtual void PrepareFrame(vtkRenderer* renderer);

  ///@{
  /// Of the pass: the same, with the bounds of the visible props (xmin, xmax, .., zmax; world)
  /// where they are known, else nullptr; until the end of the frame PrepareFrame then has nothing
  /// to do. framebuffer: width and height in pixels of what is drawn to, where that is another than
  /// the renderer's part of the window, else nullptr.
  void BeginFrame(vtkRenderer* renderer, const double* bounds, const int* framebuffer = nullptr);
  void EndFrame();
  ///@}

  ///@{
  /// As vtkCamera's, and the wide view with them where the source has one.
  void ShallowCopy(vtkCamera* source);
  void DeepCopy(vtkCamera* source);
  ///@}

  ///@{
  /// While a wide frame is drawn, the angle in degrees by which VTK makes what is to be so many
  /// pixels large as large as that in the middle of the picture, and a normal of the view plane
  /// behind which nothing is where SetNothingBehind asks for that; at all other times vtkCamera's
  /// own.
  double GetViewAngle() override;
  double* GetViewPlaneNormal() VTK_SIZEHINT(3) override;
  using Superclass::GetViewPlaneNormal;
  ///@}

  /// As vtkCamera's. No matrix is a wide view, and one warning says so where places are found by
  /// that to depths from 0 to 1, as of vtkSelectVisiblePoints and vtkDepthImageToPointCloud.
  vtkMatrix4x4* GetCompositeProjectionTransformMatrix(
    double aspect, double nearz, double farz) override;

  ///@{
  /// What the stock pipeline asks for. The projection matrix of a wide camera is the identity.
  void Render(vtkRenderer* renderer) override;
  void UpdateViewport(vtkRenderer* renderer) override;
  void GetKeyMatrices(vtkRenderer* renderer, vtkMatrix4x4*& wcvc, vtkMatrix3x3*& normals,
    vtkMatrix4x4*& vcdc, vtkMatrix4x4*& wcdc) override;
  void GetFrustumPlanes(double aspect, double planes[24]) override;
  ///@}

  /// Also updates the view transform if the current eye turns by another angle now.
  void Modified() override;

protected:
  vtkWideFoVCamera();
  ~vtkWideFoVCamera() override;

  /// A camera with this one's view. VTK's screenshots draw with a new instance that only
  /// vtkCamera's own, non-virtual copy functions fill.
  vtkObjectBase* NewInstanceInternal() const override;

  virtual void CopyView(const vtkWideFoVCamera* source);
  void ComputeProjectionTransform(double aspect, double nearz, double farz) override;
  void ComputeViewTransform() override;

  // Where distances are measured from, world.
  virtual void GetViewpoint(double world[3]);

#ifndef __VTK_WRAP__
  // Takes the options over, or refuses them with an error where this model says why.
  bool SetStereoOptions(const wfv::StereoModel& model, const wfv::StereoOptions& options);

  // The stereo model, where the projection is one that it is made for; else nullptr.
  virtual const wfv::StereoModel* GetFittingModel();
  virtual const wfv::Projection& GetDrawnProjection(); // framed, where ExactPerspective holds

  // Of a perspective: half its width and height at distance 1, and where its axis is, NDC.
  void SetFrustum(const double half[2], const double center[2]);
  // For a perspective of which half the width at distance 1 is tx: where the eye is (scene
  // units to the right) and by how much its picture is shifted (NDC).
  void GetFlatEye(double tx, double& position, double& shift);
  void GetFrustumPlanesOfBoth(double aspect, double planes[24]);
  void FindEye(vtkRenderer* renderer);
  // One warning a process for each property of vtkCamera that is set and that no view has.
  void WarnOfWhatIsIgnored(vtkRenderer* renderer);

  // The viewport of all that is drawn to; false where that is the renderer's part of the window.
  bool TakeFramebuffer(vtkRenderer* renderer);

  // One warning a process where this camera is that of a renderer whose props no pass gives stages.
  void WarnOfFlatRenderer(vtkRenderer* renderer);

  // The field of view that SetViewAngle means, degrees.
  double GetFieldOfViewAngle();

  void FitClipRadii(vtkRenderer* renderer); // to what its frame shows
  void FindPart(vtkRenderer* renderer);     // of a perspective, that the window shows as a tile
  void ToWorld(const wfv::ViewRay& ray, double origin[3], double direction[3]);
#endif

  vtkTypeBool AutomaticClipRadii = 1;
  vtkTypeBool ExactPerspective = 0;

private:
  vtkWideFoVCamera(const vtkWideFoVCamera&) = delete;
  void operator=(const vtkWideFoVCamera&) = delete;

  struct Clipping;
  struct Internals;
  std::unique_ptr<Internals> Internal;
  const wfv::Projection* Definition;
};
VTK_ABI_NAMESPACE_END

#endif

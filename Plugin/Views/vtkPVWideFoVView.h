// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPVWideFoVView
 * @brief   ParaView's render view, in any projection that vtkWideFoVCamera knows
 *
 * The same object on the client and on every server process: each sets up its own
 * camera and pass from the properties, which the server manager sends to all, and the
 * position of the eye comes with each frame, as for any render view.
 *
 * Angles are in degrees, distances in the units of the data.
 */
#ifndef vtkPVWideFoVView_h
#define vtkPVWideFoVView_h

#include "vtkPVRenderView.h"
#include "vtkWideFoVPluginViewsModule.h" // For export macro

#include <memory> // For std::unique_ptr

class VTKWIDEFOVPLUGINVIEWS_EXPORT vtkPVWideFoVView : public vtkPVRenderView
{
public:
  static vtkPVWideFoVView* New();
  vtkTypeMacro(vtkPVWideFoVView, vtkPVRenderView);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The projection, by its name in the registry (default "equirectangular"). An unknown
   * name is refused with an error that lists the known ones.
   */
  virtual void SetProjection(const char* name);

  ///@{
  /**
   * Fields of view in degrees (defaults 360 and 180), as far as the projection can show
   * them. Round projections use the horizontal one alone.
   */
  virtual void SetHorizontalFieldOfView(double degrees);
  virtual void SetVerticalFieldOfView(double degrees);
  ///@}

  /**
   * Degrees by which the axis is raised towards view up, in [-180, 180] (default 0).
   */
  virtual void SetTilt(double degrees);

  /**
   * Lens polynomial, see vtkWideFoVCamera::SetLens; five zeros, the default, are the
   * ideal lens.
   */
  virtual void SetLens(double c1, double c2, double c3, double c4, double c5);

  /**
   * What the projection "direction-map" shows, an OpenEXR image of a direction a pixel (default:
   * none, which shows nothing). A file that is none is refused with an error, and the old map
   * stays. Every process reads it.
   */
  virtual void SetDirectionMapFile(const char* path);

  /**
   * Fit the clip spheres to the visible data before each frame (default on).
   */
  virtual void SetAutomaticClipSpheres(bool automatic);

  /**
   * Radii of the clip spheres, 0 < near < far, used while they are not automatic
   * (default 0.01 and 1000).
   */
  virtual void SetClipSpheres(double nearRadius, double farRadius);

  /**
   * One of vtkWideFoVCamera::DepthMappings (default LINEAR).
   */
  virtual void SetDepthMapping(int mapping);

  ///@{
  /**
   * How the eyes of the view's stereo types differ, see the setters of these names in
   * vtkWideFoVCamera (default: the model with eyes on a circle, 0.065 units apart). Without
   * stereo rendering they change nothing. What a camera refuses leaves the old value.
   */
  virtual void SetStereoModel(const char* name);
  virtual void SetInterpupillaryDistance(double distance);
  virtual void SetPoleFade(double start, double end);
  virtual void SetWarpedStereo(double iod, double distance, double offset);
  virtual void SetSeparation(double fraction);
  virtual void SetConvergence(double distance);
  ///@}

  /**
   * One of vtkWideFoVPass::Techniques (default AUTO).
   */
  virtual void SetTechnique(int technique);

  /**
   * Pixels, in [0.001, 1e6] (default 0.25), see vtkWideFoVPass::SetTolerance.
   */
  virtual void SetTolerance(double pixels);

  /**
   * The middle of what is visible, world coordinates. False, and no change, where nothing is.
   */
  bool GetMiddleOfData(double middle[3]);

  void SetActiveCamera(vtkCamera* camera) override;
  void ResetCameraClippingRange() override;

protected:
  vtkPVWideFoVView();
  ~vtkPVWideFoVView() override;

  void AboutToRenderOnLocalProcess(bool interactive) override;

private:
  vtkPVWideFoVView(const vtkPVWideFoVView&) = delete;
  void operator=(const vtkPVWideFoVView&) = delete;

  // The settings to the camera that draws, whichever that is now.
  void UpdateCamera();

  // The stereo settings to the camera; none while the window shows one eye alone.
  void UpdateStereo();

  // The clip spheres to the data, or as they are set; the same on every process.
  void UpdateClipSpheres();

  // Until data have been drawn ParaView's reset puts the eye into them, if it looks behind itself.
  void PlaceFirstEye();

  // How many pixels of a frame the ranks leave out.
  void UpdateReduction();

  // Around each frame of the renderer: the eye is where the client says.
  void StartFrame();
  void EndFrame();

  struct Internals;
  std::unique_ptr<Internals> Internal;
};

#endif

// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkWideFoVScreenCamera
 * @brief   what somebody sees through a flat screen that stands in a room: a wall, a CAVE
 *
 * Position, focal point and view up place the room in the scene: its origin, its direction
 * ahead (-z) and its up (y). Screen and head are given in the room's coordinates, in scene
 * units. Moving the head moves the eyes before the screen and nothing else, so the scene keeps
 * its place in the room; a head that carries its display along turns the room instead.
 *
 * In a window in stereo mode, whatever its stereo type, each eye is half the interpupillary
 * distance from the middle of the head, along the head's own x axis. Stereo models and tilt
 * have no effect, and the projection is "perspective" always.
 *
 * View coordinates are those of the eye before the screen: x and y along the screen's sides. So
 * all of stock VTK that thinks in the plane of the picture is right. Unlike vtkCamera's own
 * off-axis projection the clip planes follow from the clip radii, the distance between the eyes
 * is what it says, and headlights, where vtkWideFoVPass draws, shine from the head in all
 * directions, so that light has no step where screens meet.
 */

#ifndef vtkWideFoVScreenCamera_h
#define vtkWideFoVScreenCamera_h

#include "vtkWideFoVAbi.h" // For VTK_ABI_NAMESPACE_BEGIN
#include "vtkWideFoVCamera.h"

#include "vtkRenderingWideFoVModule.h" // For export macro

VTK_ABI_NAMESPACE_BEGIN
class VTKRENDERINGWIDEFOV_EXPORT vtkWideFoVScreenCamera : public vtkWideFoVCamera
{
public:
  ///@{
  /**
   * Standard methods of a VTK class.
   */
  static vtkWideFoVScreenCamera* New();
  vtkAbstractTypeMacro(vtkWideFoVScreenCamera, vtkWideFoVCamera);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  ///@}

  ///@{
  /**
   * Three corners of the screen as its viewers see it (default: from -1 to 1, one unit ahead).
   * Corners that are not finite, span no area or are not those of a rectangle are refused with
   * an error; the old ones stay.
   */
  virtual bool SetScreen(
    const double lowerLeft[3], const double lowerRight[3], const double upperRight[3]);
  virtual void GetScreen(double lowerLeft[3], double lowerRight[3], double upperRight[3]);
  ///@}

  ///@{
  /**
   * Where the head is (default 0, 0, 0), and how it is turned: a quaternion from its own (x
   * right, y up, z behind) to the room's coordinates, of any length but 0 (default 0, 0, 0, 1:
   * not turned). Anything else is refused with an error.
   */
  virtual bool SetHeadPosition(double x, double y, double z);
  virtual void GetHeadPosition(double position[3]);
  virtual bool SetHeadTurn(double x, double y, double z, double w);
  virtual void GetHeadTurn(double quaternion[4]);
  ///@}

  /**
   * Distance of the present eye from the plane of the screen; below 0 behind it, where nothing
   * sensible can be seen and what is drawn is what an eye just before the plane sees.
   */
  virtual double GetScreenDistance();

  /// The projection is "perspective"; another one is refused with an error.
  void SetProjection(const char* name) override;

  /// Distance between the two eyes of the head, scene units, at least 0 (default 0.065).
  void SetInterpupillaryDistance(double distance) override;

  ///@{
  /**
   * As the camera's, of the eye before the screen.
   */
  void PrepareFrame(vtkRenderer* renderer) override;
  void GetFrustumPlanes(double aspect, double planes[24]) override;
  double GetBaselineRadius() override;
  ///@}

protected:
  vtkWideFoVScreenCamera();
  ~vtkWideFoVScreenCamera() override;

  vtkObjectBase* NewInstanceInternal() const override;
  void CopyView(const vtkWideFoVCamera* source) override;
  void ComputeViewTransform() override;
#ifndef __VTK_WRAP__
  // Stock VTK draws screens, where the head is straight before one too.
  const wfv::Projection& GetDrawnProjection() override
  {
    return this->GetProjectionDefinition();
  }
  const wfv::StereoModel* GetFittingModel() override
  {
    return nullptr;
  }
#endif
  void GetViewpoint(double world[3]) override;

private:
  vtkWideFoVScreenCamera(const vtkWideFoVScreenCamera&) = delete;
  void operator=(const vtkWideFoVScreenCamera&) = delete;

  // What follows from the present eye.
  void UpdateEye();

  struct Room;
  std::unique_ptr<Room> In;
};
VTK_ABI_NAMESPACE_END

#endif

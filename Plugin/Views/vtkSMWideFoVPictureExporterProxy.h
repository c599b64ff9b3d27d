// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSMWideFoVPictureExporterProxy
 * @brief   a Wide FoV View as a picture of any size, with two eyes and metadata
 *
 * What File, Export View and ExportView make of a file that ends in .png or .jpg.
 */
#ifndef vtkSMWideFoVPictureExporterProxy_h
#define vtkSMWideFoVPictureExporterProxy_h

#include "vtkSMExporterProxy.h"
#include "vtkWideFoVPluginViewsModule.h" // For export macro

class VTKWIDEFOVPLUGINVIEWS_EXPORT vtkSMWideFoVPictureExporterProxy : public vtkSMExporterProxy
{
public:
  static vtkSMWideFoVPictureExporterProxy* New();
  vtkTypeMacro(vtkSMWideFoVPictureExporterProxy, vtkSMExporterProxy);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  bool CanExport(vtkSMProxy* view) override;
  void Write() override;

protected:
  vtkSMWideFoVPictureExporterProxy() = default;
  ~vtkSMWideFoVPictureExporterProxy() override = default;

private:
  vtkSMWideFoVPictureExporterProxy(const vtkSMWideFoVPictureExporterProxy&) = delete;
  void operator=(const vtkSMWideFoVPictureExporterProxy&) = delete;
};

#endif

// SPDX-License-Identifier: BSD-3-Clause
// vtkPVWideFoVVersion: the version of the plugin in another process. ParaView's own
// vtkPVPluginsInformation tells it as well, but that of ParaView 6.1 is empty.
#ifndef vtkPVWideFoVVersion_h
#define vtkPVWideFoVVersion_h

#include "vtkPVInformation.h"
#include "vtkWideFoVPluginViewsModule.h" // For export macro

#include <string>

class VTKWIDEFOVPLUGINVIEWS_EXPORT vtkPVWideFoVVersion : public vtkPVInformation
{
public:
  static vtkPVWideFoVVersion* New();
  vtkTypeMacro(vtkPVWideFoVVersion, vtkPVInformation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  // As "0.1.0"; empty where the plugin is not loaded.
  const std::string& GetVersion() const { return this->Version; }

  // Of this process, whatever the object.
  void CopyFromObject(vtkObject*) override;
  void AddInformation(vtkPVInformation* other) override;
  void CopyToStream(vtkClientServerStream* stream) override;
  void CopyFromStream(const vtkClientServerStream* stream) override;

protected:
  vtkPVWideFoVVersion();
  ~vtkPVWideFoVVersion() override;

private:
  vtkPVWideFoVVersion(const vtkPVWideFoVVersion&) = delete;
  void operator=(const vtkPVWideFoVVersion&) = delete;

  std::string Version;
};

#endif

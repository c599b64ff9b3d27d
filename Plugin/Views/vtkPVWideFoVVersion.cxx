// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVWideFoVVersion.h"

#include "vtkClientServerStream.h"
#include "vtkObjectFactory.h"
#include "vtkPVPlugin.h"
#include "vtkPVPluginTracker.h"

vtkStandardNewMacro(vtkPVWideFoVVersion);

vtkPVWideFoVVersion::vtkPVWideFoVVersion()
{
  this->SetRootOnly(1);
}

vtkPVWideFoVVersion::~vtkPVWideFoVVersion() = default;

void vtkPVWideFoVVersion::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Version: " << this->Version << "\n";
}

void vtkPVWideFoVVersion::CopyFromObject(vtkObject*)
{
  this->Version.clear();
  vtkPVPluginTracker* const tracker = vtkPVPluginTracker::GetInstance();
  for (unsigned int i = 0; i < tracker->GetNumberOfPlugins(); i++)
  {
    vtkPVPlugin* const plugin = tracker->GetPlugin(i); // none where it is only known
    if (plugin && std::string(plugin->GetPluginName()) == "WideFoV")
    {
      this->Version = plugin->GetPluginVersionString();
    }
  }
}

void vtkPVWideFoVVersion::AddInformation(vtkPVInformation* other)
{
  if (auto* const one = vtkPVWideFoVVersion::SafeDownCast(other))
  {
    this->Version = one->Version;
  }
}

void vtkPVWideFoVVersion::CopyToStream(vtkClientServerStream* stream)
{
  stream->Reset();
  *stream << vtkClientServerStream::Reply << this->Version << vtkClientServerStream::End;
}

void vtkPVWideFoVVersion::CopyFromStream(const vtkClientServerStream* stream)
{
  const char* text = nullptr;
  this->Version = stream->GetArgument(0, 0, &text) && text ? text : "";
}

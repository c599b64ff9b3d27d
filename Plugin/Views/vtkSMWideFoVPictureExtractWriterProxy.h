// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSMWideFoVPictureExtractWriterProxy
 * @brief   numbered pictures of a Wide FoV View, by ParaView's extractors
 *
 * One picture each time the extractor is triggered: for every time step in batch, in situ
 * with Catalyst, or by File, Save Extracts.
 */
#ifndef vtkSMWideFoVPictureExtractWriterProxy_h
#define vtkSMWideFoVPictureExtractWriterProxy_h

#include "vtkSMExtractWriterProxy.h"
#include "vtkWideFoVPluginViewsModule.h" // For export macro

class VTKWIDEFOVPLUGINVIEWS_EXPORT vtkSMWideFoVPictureExtractWriterProxy
  : public vtkSMExtractWriterProxy
{
public:
  static vtkSMWideFoVPictureExtractWriterProxy* New();
  vtkTypeMacro(vtkSMWideFoVPictureExtractWriterProxy, vtkSMExtractWriterProxy);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  bool Write(vtkSMExtractsController* extractor) override;
  bool CanExtract(vtkSMProxy* proxy) override;
  bool IsExtracting(vtkSMProxy* proxy) override;
  void SetInput(vtkSMProxy* proxy) override;
  vtkSMProxy* GetInput() override;

protected:
  vtkSMWideFoVPictureExtractWriterProxy() = default;
  ~vtkSMWideFoVPictureExtractWriterProxy() override = default;

private:
  vtkSMWideFoVPictureExtractWriterProxy(const vtkSMWideFoVPictureExtractWriterProxy&) = delete;
  void operator=(const vtkSMWideFoVPictureExtractWriterProxy&) = delete;
};

#endif

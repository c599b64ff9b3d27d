// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkWideFoVPictureWriter
 * @brief   a .png or .jpg file that appears whole or not at all, with XMP in it
 *
 * The input is a picture of one, three or four components of unsigned char. Folders that do
 * not exist yet are made. What fails is an error, and leaves no file.
 */
#ifndef vtkWideFoVPictureWriter_h
#define vtkWideFoVPictureWriter_h

#include "vtkImageWriter.h"
#include "vtkWideFoVPluginViewsModule.h" // For export macro

#include <string> // For std::string
#include <vector> // For std::vector

class VTKWIDEFOVPLUGINVIEWS_EXPORT vtkWideFoVPictureWriter : public vtkImageWriter
{
public:
  static vtkWideFoVPictureWriter* New();
  vtkTypeMacro(vtkWideFoVPictureWriter, vtkImageWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Writes the file. Its name ends in .png, .jpg or .jpeg.
   */
  void Write() override;

  ///@{
  /**
   * The XMP packet to put into the file (default: none).
   */
  vtkSetStringMacro(Xmp);
  vtkGetStringMacro(Xmp);
  ///@}

  ///@{
  /**
   * Of JPEG, 0 to 100 (default 95).
   */
  vtkSetClampMacro(Quality, int, 0, 100);
  vtkGetMacro(Quality, int);
  ///@}

protected:
  vtkWideFoVPictureWriter() = default;
  ~vtkWideFoVPictureWriter() override;

private:
  vtkWideFoVPictureWriter(const vtkWideFoVPictureWriter&) = delete;
  void operator=(const vtkWideFoVPictureWriter&) = delete;

  // The bytes of the file; none where that is an error, which has been said.
  std::vector<unsigned char> Encode(const std::string& path);

  char* Xmp = nullptr;
  int Quality = 95;
};

#endif

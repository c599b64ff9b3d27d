// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/DirectionTextures.h"

#include "Compat/Gl.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"

#include <utility>

void wfv::DirectionTextures::Upload(vtkTextureObject* texture, vtkOpenGLRenderWindow* window,
  const std::vector<wfv::DirectionMap::Texel>& table, int width, int height)
{
  texture->SetContext(window);
  texture->SetInternalFormat(GL_RGBA32F);
  texture->SetFormat(GL_RGBA);
  texture->SetDataType(GL_FLOAT);
  texture->SetMinificationFilter(vtkTextureObject::Nearest);
  texture->SetMagnificationFilter(vtkTextureObject::Nearest);
  // the interface is not const, but only reads
  texture->Create2DFromRaw(static_cast<unsigned int>(width), static_cast<unsigned int>(height), 4,
    VTK_FLOAT, const_cast<float*>(table.front().data()));
}

void wfv::DirectionTextures::Load(const wfv::DirectionMap* map, vtkOpenGLRenderWindow* window)
{
  const unsigned long serial = map ? map->GetSerial() : 0;
  if (!map || (serial == this->Serial && this->Directions->GetHandle() != 0))
  {
    return;
  }
  this->Serial = serial;
  const int cells = map->GetCells();
  Upload(this->Directions, window, map->GetDirections(), map->GetWidth(), map->GetHeight());
  Upload(this->Cells, window, map->GetCellBounds(), 12 * cells, map->GetCellBoundsHeight());
  Upload(this->Seeds, window, map->GetSeeds(), 12 * cells, cells);
}

void wfv::DirectionTextures::Bind(vtkShaderProgram* program)
{
  const std::pair<const char*, vtkTextureObject*> all[] = { { "wfvDirections", this->Directions },
    { "wfvCells", this->Cells }, { "wfvSeeds", this->Seeds } };
  for (const auto& [name, texture] : all)
  {
    if (texture->GetHandle() != 0 && program->IsUniformUsed(name))
    {
      texture->Activate();
      program->SetUniformi(name, texture->GetTextureUnit());
    }
  }
}

void wfv::DirectionTextures::Unbind()
{
  for (vtkTextureObject* texture : { this->Directions.Get(), this->Cells.Get(), this->Seeds.Get() })
  {
    if (texture->GetHandle() != 0)
    {
      texture->Deactivate();
    }
  }
}

void wfv::DirectionTextures::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Directions->ReleaseGraphicsResources(window);
  this->Cells->ReleaseGraphicsResources(window);
  this->Seeds->ReleaseGraphicsResources(window);
  this->Serial = 0;
}

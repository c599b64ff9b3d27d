// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWideFoVDataPass.h"

#include "Compat/Gl.h"
#include "Compat/StockText.h"
#include "Drawables/Kinds/DrawableKinds.h"
#include "Drawables/StockTraits.h"
#include "Shaders/aov/DataShaders.h"
#include "vtkWideFoVCamera.h"

#include "vtkActor.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLCellToVTKCellMap.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLRenderer.h"
#include "vtkOpenGLState.h"
#include "vtkPixelBufferObject.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderState.h"
#include "vtkShaderProgram.h"
#include "vtkSmartPointer.h"
#include "vtkTextureObject.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

vtkStandardNewMacro(vtkWideFoVDataPass);

namespace
{
// Attachments: colour; distance, primitive, prop; normal.
constexpr int Attachments = 3;

vtkSmartPointer<vtkFloatArray> AddArray(vtkImageData* image, const char* name, int components)
{
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(image->GetNumberOfPoints());
  image->GetPointData()->AddArray(array);
  return array;
}

// A primitive is a point.
bool DrawsPoints(vtkProp* prop)
{
  auto* actor = vtkActor::SafeDownCast(prop);
  return actor && wfv::HasTrait(actor->GetMapper(), wfv::PointsAlone);
}

// Primitive numbers of the mapper's draws back to cells of its polydata.
vtkSmartPointer<vtkOpenGLCellToVTKCellMap> CellMap(vtkProp* prop)
{
  auto* actor = vtkActor::SafeDownCast(prop);
  auto* mapper = actor ? vtkPolyDataMapper::SafeDownCast(actor->GetMapper()) : nullptr;
  vtkPolyData* input = mapper ? mapper->GetInput() : nullptr;
  if (!input || DrawsPoints(prop))
  {
    return nullptr;
  }
  vtkCellArray* cells[4] = { input->GetVerts(), input->GetLines(), input->GetPolys(),
    input->GetStrips() };
  auto map = vtkSmartPointer<vtkOpenGLCellToVTKCellMap>::New();
  map->Update(cells, actor->GetProperty()->GetRepresentation(), input->GetPoints());
  return map;
}
}

namespace
{
struct IndexedProp
{
  vtkWeakPointer<vtkProp> Prop;
  int Index;
};
}

struct vtkWideFoVDataPass::Internals
{
  vtkSmartPointer<vtkRenderPass> Delegate;
  std::vector<IndexedProp> Props; // numbered from 1 in the order given
  vtkNew<vtkImageData> Output;
  vtkNew<vtkOpenGLFramebufferObject> Framebuffer;
  vtkNew<vtkTextureObject> Color[Attachments];
  vtkNew<vtkTextureObject> Depth;
  float Eye[3] = { 0, 0, 0 };                   // of a perspective in stereo, view coordinates
  vtkNew<vtkMatrix4x4> ClipToView, PixelToView; // transposed, as VTK's uniforms are
  int Size[2] = { 0, 0 };
  bool Wide = false; // the delegate brings surface edges of its own

  void Allocate(vtkOpenGLRenderWindow* window, int width, int height);
  void Bind();
  void Clear(vtkRenderer* renderer);
  void Prepare(vtkRenderer* renderer); // the camera's side of a frame
  void Read();
  void Decode(const std::vector<float>& data, const std::vector<float>& normal);
};

vtkWideFoVDataPass::vtkWideFoVDataPass()
  : Internal(new Internals)
{
}

vtkWideFoVDataPass::~vtkWideFoVDataPass() = default;

void vtkWideFoVDataPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "DelegatePass: " << this->Internal->Delegate.Get() << "\n"
     << indent << "Props with an index: " << this->Internal->Props.size() << "\n";
}

void vtkWideFoVDataPass::SetDelegatePass(vtkRenderPass* pass)
{
  if (this->Internal->Delegate != pass)
  {
    this->Internal->Delegate = pass;
    this->Modified();
  }
}

vtkRenderPass* vtkWideFoVDataPass::GetDelegatePass()
{
  return this->Internal->Delegate;
}

void vtkWideFoVDataPass::SetPropIndex(vtkProp* prop, int index)
{
  for (IndexedProp& entry : this->Internal->Props)
  {
    if (entry.Prop == prop)
    {
      entry.Index = index;
      return;
    }
  }
  this->Internal->Props.push_back({ prop, index });
}

vtkImageData* vtkWideFoVDataPass::GetOutput()
{
  return this->Internal->Output;
}

void vtkWideFoVDataPass::Internals::Allocate(vtkOpenGLRenderWindow* window, int width, int height)
{
  const bool fits = this->Size[0] == width && this->Size[1] == height;
  if (!fits)
  {
    // it takes a texture it knows for attached, whatever became of its storage
    this->Framebuffer->ReleaseGraphicsResources(window);
    for (auto& texture : this->Color)
    {
      texture->ReleaseGraphicsResources(window);
      texture->SetContext(window);
      texture->SetInternalFormat(GL_RGBA32F);
      texture->SetFormat(GL_RGBA);
      texture->SetDataType(GL_FLOAT);
      texture->Allocate2D(width, height, 4, VTK_FLOAT);
    }
    this->Depth->ReleaseGraphicsResources(window);
    this->Depth->SetContext(window);
    this->Depth->AllocateDepth(width, height, vtkTextureObject::Float32);
    this->Size[0] = width;
    this->Size[1] = height;
  }
  this->Framebuffer->SetContext(window);
}

void vtkWideFoVDataPass::Internals::Clear(vtkRenderer* renderer)
{
  const double* b = renderer->GetBackground();
  const float background[4] = { static_cast<float>(b[0]), static_cast<float>(b[1]),
    static_cast<float>(b[2]), static_cast<float>(renderer->GetBackgroundAlpha()) };
  // not infinity for the distance: blending would make it NaN
  const float zero[4] = { 0, 0, 0, 0 };
  const float far = 1;
  glDepthMask(GL_TRUE);
  glClearBufferfv(GL_COLOR, 0, background);
  glClearBufferfv(GL_COLOR, 1, zero);
  glClearBufferfv(GL_COLOR, 2, zero);
  glClearBufferfv(GL_DEPTH, 0, &far);
}

void vtkWideFoVDataPass::Internals::Read()
{
  const vtkIdType pixels = static_cast<vtkIdType>(this->Size[0]) * this->Size[1];
  this->Output->Initialize();
  this->Output->SetDimensions(this->Size[0], this->Size[1], 1);
  std::vector<float> buffers[Attachments];
  for (int i = 0; i < Attachments; i++)
  {
    buffers[i].resize(4 * pixels);
    unsigned int size[2] = { static_cast<unsigned int>(this->Size[0]),
      static_cast<unsigned int>(this->Size[1]) };
    vtkIdType increments[2] = { 0, 0 };
    vtkPixelBufferObject* pixelBuffer = this->Color[i]->Download();
    pixelBuffer->Download2D(VTK_FLOAT, buffers[i].data(), size, 4, increments);
    pixelBuffer->Delete();
  }
  auto color = AddArray(this->Output, "color", 4);
  std::copy(buffers[0].begin(), buffers[0].end(), color->GetPointer(0));
  this->Decode(buffers[1], buffers[2]);
}

void vtkWideFoVDataPass::Internals::Decode(
  const std::vector<float>& data, const std::vector<float>& normals)
{
  std::vector<vtkSmartPointer<vtkOpenGLCellToVTKCellMap>> maps;
  std::vector<bool> points;
  for (const IndexedProp& entry : this->Props)
  {
    maps.push_back(CellMap(entry.Prop));
    points.push_back(DrawsPoints(entry.Prop));
  }
  auto distance = AddArray(this->Output, "distance", 1);
  auto cell = AddArray(this->Output, "cell", 1);
  auto prop = AddArray(this->Output, "prop", 1);
  auto normal = AddArray(this->Output, "normal", 3);
  const vtkIdType pixels = this->Output->GetNumberOfPoints();
  for (vtkIdType i = 0; i < pixels; i++)
  {
    const float* d = &data[4 * i];
    const int number = static_cast<int>(d[2]) - 1;
    const bool known = number >= 0 && number < static_cast<int>(maps.size());
    const vtkIdType primitive = static_cast<vtkIdType>(d[1]) - 1;
    vtkIdType id = 0;
    if (known && maps[number] && primitive >= 0)
    {
      id = maps[number]->ConvertOpenGLCellIdToVTKCellId(false, primitive) + 1;
    }
    else if (known && points[number])
    {
      id = primitive + 1;
    }
    distance->SetValue(i, d[3] > 0 ? d[0] : std::numeric_limits<float>::infinity());
    prop->SetValue(i, known ? static_cast<float>(this->Props[number].Index + 1) : 0.0f);
    cell->SetValue(i, static_cast<float>(id));
    normal->SetTypedTuple(i, &normals[4 * i]);
  }
}

void vtkWideFoVDataPass::Internals::Bind()
{
  this->Framebuffer->Bind();
  for (int i = 0; i < Attachments; i++)
  {
    this->Framebuffer->AddColorAttachment(i, this->Color[i]);
  }
  this->Framebuffer->AddDepthAttachment(this->Depth);
  this->Framebuffer->ActivateDrawBuffers(Attachments);
}

void vtkWideFoVDataPass::Internals::Prepare(vtkRenderer* renderer)
{
  auto* camera = vtkOpenGLCamera::SafeDownCast(renderer->GetActiveCamera());
  auto* wide = vtkWideFoVCamera::SafeDownCast(camera);
  this->Wide = wide && wide->IsWide();
  if (wide)
  {
    wide->PrepareFrame(renderer);
    wide->GetPerspectiveEye(renderer->GetTiledAspectRatio(), this->Eye);
    wide->ExpectStage(); // the matrices are read here, and nothing is drawn by them
  }
  vtkMatrix4x4* toView;
  vtkMatrix4x4* toClip;
  vtkMatrix4x4* toBoth;
  vtkMatrix3x3* normals;
  camera->GetKeyMatrices(renderer, toView, normals, toClip, toBoth);
  vtkMatrix4x4::Invert(toClip, this->ClipToView);
  int part[4];
  renderer->GetTiledSizeAndOrigin(&part[2], &part[3], &part[0], &part[1]);
  const double x = 2.0 / part[2], y = 2.0 / part[3];
  const double toNdc[] = { x, 0, 0, 0, 0, y, 0, 0, 0, 0, 2, 0, -x * part[0] - 1, -y * part[1] - 1,
    -1, 1 };
  vtkMatrix4x4::Multiply4x4(toNdc, this->ClipToView->GetData(), this->PixelToView->GetData());
}

void vtkWideFoVDataPass::Render(const vtkRenderState* s)
{
  Internals& in = *this->Internal;
  auto* renderer = vtkOpenGLRenderer::SafeDownCast(s->GetRenderer());
  auto* window =
    renderer ? vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow()) : nullptr;
  if (!window || !in.Delegate)
  {
    vtkErrorMacro(<< "A delegate pass and a renderer with an OpenGL window are needed");
    return;
  }
  int part[4];
  renderer->GetTiledSizeAndOrigin(&part[2], &part[3], &part[0], &part[1]);
  vtkOpenGLState* state = window->GetState();
  state->PushFramebufferBindings();
  in.Allocate(window, part[0] + part[2], part[1] + part[3]);
  in.Bind();
  vtkOpenGLState::ScopedglEnableDisable scissor(state, GL_SCISSOR_TEST);
  state->vtkglDisable(GL_SCISSOR_TEST);
  in.Clear(renderer);
  in.Prepare(renderer);

  const vtkTypeBool erase = renderer->GetErase();
  renderer->EraseOff();
  this->PreRender(s);
  in.Delegate->Render(s);
  this->PostRender(s);
  renderer->SetErase(erase);
  state->PopFramebufferBindings();
  this->NumberOfRenderedProps = in.Delegate->GetNumberOfRenderedProps();
  in.Read();
}

bool vtkWideFoVDataPass::PreReplaceShaderValues(std::string&, std::string& geometryShader,
  std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop)
{
  wfv::data::Prepare(
    wfv::stock::Describe(mapper, prop), this->Internal->Wide, geometryShader, fragmentShader);
  return true;
}

bool vtkWideFoVDataPass::PostReplaceShaderValues(std::string& vertexShader,
  std::string& geometryShader, std::string& fragmentShader, vtkAbstractMapper* mapper,
  vtkProp* prop)
{
  if (wfv::stock::DrawsNothing(fragmentShader))
  {
    return true;
  }
  wfv::data::Finish(wfv::stock::Describe(mapper, prop), this->Internal->Wide, vertexShader,
    geometryShader, fragmentShader);
  wfv::stock::LeaveOutUnedited(this, mapper, vertexShader, geometryShader, fragmentShader);
  return true;
}

bool vtkWideFoVDataPass::SetShaderParameters(
  vtkShaderProgram* program, vtkAbstractMapper*, vtkProp* prop, vtkOpenGLVertexArrayObject*)
{
  int number = 0;
  const std::vector<IndexedProp>& props = this->Internal->Props;
  for (size_t i = 0; i < props.size(); i++)
  {
    number = props[i].Prop == prop && props[i].Index >= 0 ? static_cast<int>(i) + 1 : number;
  }
  program->SetUniformi("wfvPropNumber", number);
  program->SetUniform3f("wfvDataEye", this->Internal->Eye);
  program->SetUniformMatrix("wfvClipToView", this->Internal->ClipToView);
  program->SetUniformMatrix("wfvPixelToView", this->Internal->PixelToView);
  return true;
}

void vtkWideFoVDataPass::ReleaseGraphicsResources(vtkWindow* window)
{
  Internals& in = *this->Internal;
  in.Framebuffer->ReleaseGraphicsResources(window);
  for (auto& texture : in.Color)
  {
    texture->ReleaseGraphicsResources(window);
  }
  in.Depth->ReleaseGraphicsResources(window);
  in.Size[0] = in.Size[1] = 0;
  if (in.Delegate)
  {
    in.Delegate->ReleaseGraphicsResources(window);
  }
  this->Superclass::ReleaseGraphicsResources(window);
}

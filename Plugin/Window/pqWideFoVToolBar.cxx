// SPDX-License-Identifier: BSD-3-Clause
#include "pqWideFoVToolBar.h"

#include <QComboBox>
#include <QIcon>
#include <QMenu>
#include <QSignalBlocker>
#include <QToolButton>

#include <pqActiveObjects.h>
#include <pqUndoStack.h>
#include <pqView.h>

#include <vtkSMProperty.h>
#include <vtkSMPropertyHelper.h>
#include <vtkSMStringListDomain.h>
#include <vtkSMTrace.h>
#include <vtkSMViewProxy.h>

#include <string>

namespace
{
// What a kind of picture is made with; degrees.
struct Preset
{
  const char* Title;
  const char* Projection;
  double HorizontalFov;
  double VerticalFov;
  double Tilt;
  int TwoEyes;
};

const Preset Presets[] = {
  { "360 photo", "equirectangular", 360, 180, 0, 0 },
  { "360 stereo video", "equirectangular", 360, 180, 0, 1 },
  { "VR180", "equirectangular", 180, 180, 0, 1 },
  { "VR180, one eye", "equirectangular", 180, 180, 0, 0 },
  { "Planetarium dome", "azimuthal-equidistant", 180, 180, 90, 0 },
  { "Planetarium dome, two eyes", "azimuthal-equidistant", 180, 180, 90, 1 },
  { "Fisheye", "azimuthal-equidistant", 180, 180, 0, 0 },
  { "Whole sphere, equal areas", "hammer", 360, 180, 0, 0 },
};

vtkSMViewProxy* WideProxy(pqView* view)
{
  vtkSMViewProxy* proxy = view ? view->getViewProxy() : nullptr;
  return proxy && std::string(proxy->GetXMLName()) == "WideFoVView" ? proxy : nullptr;
}

void Apply(const Preset& preset)
{
  pqView* const view = pqActiveObjects::instance().activeView();
  vtkSMViewProxy* const proxy = WideProxy(view);
  if (!proxy)
  {
    return;
  }
  BEGIN_UNDO_SET(preset.Title);
  {
    SM_SCOPED_TRACE(PropertiesModified).arg("proxy", proxy);
    vtkSMPropertyHelper(proxy, "Projection").Set(preset.Projection);
    vtkSMPropertyHelper(proxy, "HorizontalFieldOfView").Set(preset.HorizontalFov);
    vtkSMPropertyHelper(proxy, "VerticalFieldOfView").Set(preset.VerticalFov);
    vtkSMPropertyHelper(proxy, "Tilt").Set(preset.Tilt);
    vtkSMPropertyHelper(proxy, "StereoRender").Set(preset.TwoEyes);
    if (preset.TwoEyes)
    {
      proxy->GetProperty("StereoModel")->ResetToXMLDefaults(); // the usual one of such pictures
    }
    proxy->UpdateVTKObjects();
  }
  END_UNDO_SET();
  view->render();
}
}

pqWideFoVToolBar::pqWideFoVToolBar(const QString& title, QWidget* parent)
  : Superclass(title, parent)
{
  this->build();
}

pqWideFoVToolBar::pqWideFoVToolBar(QWidget* parent)
  : Superclass(parent)
{
  this->setWindowTitle("Wide FoV");
  this->build();
}

pqWideFoVToolBar::~pqWideFoVToolBar() = default;

void pqWideFoVToolBar::build()
{
  this->setObjectName("WideFoVToolBar"); // under which the window remembers its place
  this->Projections = new QComboBox(this);
  this->Projections->setObjectName("Projections");
  this->Projections->setToolTip("Projection of the active Wide FoV View");
  this->Projections->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  this->addWidget(this->Projections);

  auto* const button = new QToolButton(this);
  button->setObjectName("Presets");
  button->setText("Presets");
  // its colours stand out from light and dark panels alike
  button->setIcon(QIcon(":/WideFoV/Icons/presets.svg"));
  button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  button->setToolTip("Projection, fields of view, tilt and eyes for a kind of picture");
  button->setPopupMode(QToolButton::InstantPopup);
  auto* const menu = new QMenu(button);
  for (const Preset& preset : Presets)
  {
    QObject::connect(
      menu->addAction(preset.Title), &QAction::triggered, [&preset] { Apply(preset); });
  }
  button->setMenu(menu);
  this->addWidget(button);

  QObject::connect(&pqActiveObjects::instance(), &pqActiveObjects::viewChanged, this,
    &pqWideFoVToolBar::followView);
  QObject::connect(
    &this->Links, &pqPropertyLinks::qtWidgetChanged, this, &pqWideFoVToolBar::render);
  // undo changes the property and leaves the picture
  QObject::connect(
    &this->Links, &pqPropertyLinks::smPropertyChanged, this, &pqWideFoVToolBar::render);
  this->followView(pqActiveObjects::instance().activeView());
}

void pqWideFoVToolBar::followView(pqView* view)
{
  this->Links.clear();
  vtkSMViewProxy* const proxy = WideProxy(view);
  this->setEnabled(proxy != nullptr);
  const QSignalBlocker quiet(this->Projections);
  this->Projections->clear();
  if (!proxy)
  {
    return;
  }
  vtkSMProperty* const property = proxy->GetProperty("Projection");
  auto* const domain = property->FindDomain<vtkSMStringListDomain>();
  for (unsigned int i = 0; i < domain->GetNumberOfStrings(); i++)
  {
    this->Projections->addItem(domain->GetString(i));
  }
  this->Links.addTraceablePropertyLink(
    this->Projections, "currentText", SIGNAL(currentTextChanged(QString)), proxy, property);
}

void pqWideFoVToolBar::render()
{
  if (pqView* const view = pqActiveObjects::instance().activeView())
  {
    view->render();
  }
}

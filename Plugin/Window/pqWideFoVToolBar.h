// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   pqWideFoVToolBar
 * @brief   the projection of the active view, presets of several properties, moves of the eye
 *
 * Enabled while a Wide FoV View is the active one. What it changes can be undone (moves of the eye
 * by ParaView's own undo of cameras) and is recorded in the trace, as changes in the properties
 * panel are.
 */
#ifndef pqWideFoVToolBar_h
#define pqWideFoVToolBar_h

#include <QToolBar>

#include <pqPropertyLinks.h>

class QComboBox;
class pqView;

class pqWideFoVToolBar : public QToolBar
{
  Q_OBJECT
  typedef QToolBar Superclass;

public:
  pqWideFoVToolBar(const QString& title, QWidget* parent = nullptr);
  pqWideFoVToolBar(QWidget* parent = nullptr);
  ~pqWideFoVToolBar() override;

private Q_SLOTS:
  // The combo box shows and sets the projection of this view, if it is a wide one.
  void followView(pqView* view);

  // The view drawn anew.
  void render();

private:
  Q_DISABLE_COPY(pqWideFoVToolBar)

  void build();

  // The buttons that move the eye and shape the layout.
  void buildMoves();

  QComboBox* Projections;
  pqPropertyLinks Links;
};

#endif

// SPDX-License-Identifier: BSD-3-Clause
// What the toolbar's buttons do with a view: where the eye is, where it looks, its shape.
#ifndef WideFoVPluginViewMoves_h
#define WideFoVPluginViewMoves_h

class pqView;
class vtkSMViewProxy;

namespace wfvplugin
{
// The view's proxy where it is a wide view, else nullptr.
vtkSMViewProxy* WideProxy(pqView* view);

// The eye in the middle of what is visible; it looks as before.
void PutEyeIntoData(pqView* view);

// The view along an axis (0 to 2) of the world, to its positive or negative end, from where the
// eye is. Up is z, or y for a view along z.
void LookAlong(pqView* view, int axis, bool positive);

// The views of this layout together twice as wide as high, or as the window is if they were that.
void ToggleTwoToOne(pqView* view);
}

#endif

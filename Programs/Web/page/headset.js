// SPDX-License-Identifier: BSD-3-Clause
// The panorama in a headset, by WebXR of three.js: each eye sees its own picture, if there are two.
import { EquirectangularAdapter } from "@photo-sphere-viewer/core";
import { Group, PerspectiveCamera } from "three";

// Scene units are metres. The eyes of a head that moves by centimetres see the same directions.
const FAR = 1e4;

const BOTH = 0; // layers of three.js
const LEFT = 1;
const RIGHT = 2;

const ICON = `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 24 24" fill="currentColor">
  <path d="M2 6h20v12h-7l-3-4-3 4H2zm5 3a2.5 2.5 0 1 0 .01 0zm10 0a2.5 2.5 0 1 0 .01 0z" fill-rule="evenodd"/></svg>`;

function addSphere(spheres, viewer, adapter, data, layer) {
  const mesh = adapter.createMesh(data.panoData);
  adapter.setTexture(mesh, data);
  viewer.renderer.setPanoramaPose(data.panoData, mesh);
  mesh.layers.set(layer);
  spheres.add(mesh);
}

// A sphere for both eyes, or one for each. Films show one picture to both.
async function makeSpheres(viewer, page) {
  const spheres = new Group();
  spheres.rotation.y = Math.PI; // three.js looks down -z, Photo Sphere Viewer along +z
  spheres.scale.setScalar(FAR / 20); // the radius is 10
  const adapter = new EquirectangularAdapter(viewer, { shader: true, useXmpData: false });
  const load = (path) => adapter.loadTexture({ path, data: page.sphere }, false);
  const left = page.film ? viewer.state.textureData : await load(page.picture);
  addSphere(spheres, viewer, adapter, left, page.right ? LEFT : BOTH);
  if (page.right) {
    addSphere(spheres, viewer, adapter, await load(page.right), RIGHT);
  }
  return spheres;
}

async function enter(viewer, page) {
  const session = await navigator.xr.requestSession("immersive-vr");
  const spheres = await makeSpheres(viewer, page);
  const camera = new PerspectiveCamera(50, 1, 0.1, FAR);
  const { renderer, scene } = viewer.renderer;
  const flat = scene.children.filter((child) => child.visible);
  flat.forEach((child) => { child.visible = false; });
  scene.add(spheres);
  renderer.xr.enabled = true;
  renderer.xr.setReferenceSpaceType("local");
  viewer.needsContinuousUpdate(true);
  viewer.renderer.setCustomRenderer(() => ({ render: () => renderer.render(scene, camera) }));
  session.addEventListener("end", () => {
    renderer.xr.enabled = false;
    scene.remove(spheres);
    flat.forEach((child) => { child.visible = true; });
    viewer.needsContinuousUpdate(false);
    viewer.renderer.setCustomRenderer(null);
  });
  await renderer.xr.setSession(session);
}

// The button of the bar that shows a page in a headset; none where there can be no headset.
export async function headsetButtons(viewer, page) {
  const there = await navigator.xr?.isSessionSupported("immersive-vr").catch(() => false);
  return there ? [{ id: "headset", title: "Headset", content: ICON, onClick: () => enter(viewer, page) }] : [];
}

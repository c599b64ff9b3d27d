// SPDX-License-Identifier: BSD-3-Clause
// Shows what /views.json lists and posts a picture of each back: a file on the inside of a sphere,
// seen by a perspective camera in its middle.
"use strict";

const RADIUS = 500;

// The part of a sphere that the file shows, its middle at -z. left and top are shares of the whole.
function makeSphere(view) {
  const across = 1 - 2 * view.left;
  const down = 1 - 2 * view.top;
  const geometry = new THREE.SphereBufferGeometry(RADIUS, 120, 60, 2 * Math.PI * view.left,
    2 * Math.PI * across, Math.PI * view.top, Math.PI * down);
  geometry.scale(-1, 1, 1); // seen from inside
  chooseEye(geometry.attributes.uv, view);
  const sphere = new THREE.Mesh(geometry);
  sphere.rotation.y = -Math.PI / 2;
  return sphere;
}

// The half of the file that belongs to an eye; v counts from the bottom.
function chooseEye(uv, view) {
  const right = view.eye === "right";
  for (let i = 0; i < uv.count; i++) {
    if (view.layout === "side by side") {
      uv.setX(i, 0.5 * uv.getX(i) + (right ? 0.5 : 0));
    } else if (view.layout === "top and bottom") {
      uv.setY(i, 0.5 * uv.getY(i) + (right ? 0 : 0.5));
    }
  }
}

function until(target, event) {
  return new Promise((resolve, reject) => {
    target.addEventListener(event, resolve, { once: true });
    target.addEventListener("error", () => reject(new Error("the player cannot read the file")));
  });
}

// A film that has been played, at a time; or a picture.
async function open(view) {
  if (view.time === undefined) {
    const image = new Image();
    image.src = view.file;
    await until(image, "load");
    return new THREE.Texture(image);
  }
  const video = document.createElement("video");
  video.muted = true; // others may not begin by themselves
  // as a whole: the test's server has no parts of files, which seeking asks for
  video.src = URL.createObjectURL(await (await fetch(view.file)).blob());
  await video.play();
  if (video.currentTime === 0) {
    await until(video, "timeupdate");
  }
  video.pause();
  const sought = until(video, "seeked");
  video.currentTime = view.time;
  await sought;
  return new THREE.VideoTexture(video);
}

async function show(renderer, view) {
  const texture = await open(view);
  texture.minFilter = THREE.LinearFilter;
  texture.generateMipmaps = false;
  texture.needsUpdate = true;
  const sphere = makeSphere(view);
  sphere.material = new THREE.MeshBasicMaterial({ map: texture });
  const scene = new THREE.Scene();
  scene.add(sphere);
  const camera = new THREE.PerspectiveCamera(view.angle, 1, 1, 2 * RADIUS);
  camera.rotation.y = -view.azimuth * Math.PI / 180; // to the right
  renderer.render(scene, camera);
  return renderer.domElement.toDataURL("image/png");
}

async function post(path, text) {
  await fetch(path, { method: "POST", body: text });
}

async function run() {
  const views = await (await fetch("views.json")).json();
  const renderer = new THREE.WebGLRenderer({ preserveDrawingBuffer: true });
  renderer.setSize(views.size, views.size, false);
  for (const [name, view] of Object.entries(views.views)) {
    await post(name, await show(renderer, view));
  }
  await post("done", "");
}

window.addEventListener("load", () => run().catch((error) => post("failed", String(error))));

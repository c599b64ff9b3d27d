// SPDX-License-Identifier: BSD-3-Clause
// The page of a panorama: Photo Sphere Viewer, and the files beside the page. page.js calls
// widefov.show with a description of them.
import { Viewer, EquirectangularAdapter } from "@photo-sphere-viewer/core";
import { CompassPlugin } from "@photo-sphere-viewer/compass-plugin";
import { EquirectangularTilesAdapter } from "@photo-sphere-viewer/equirectangular-tiles-adapter";
import { EquirectangularVideoAdapter } from "@photo-sphere-viewer/equirectangular-video-adapter";
import { VideoPlugin } from "@photo-sphere-viewer/video-plugin";
import "@photo-sphere-viewer/core/index.css";
import "@photo-sphere-viewer/compass-plugin/index.css";
import "@photo-sphere-viewer/video-plugin/index.css";
import { headsetButtons } from "./headset.js";
import "./page.css";

const NO_WEBGL = "This browser has no WebGL 2, so the panorama does not turn; this is all of it, flat.";

const CANNOT_PLAY = "This browser cannot play the film (H.264 in MP4, of this size); another browser may.";
const CANNOT_LOAD = "The page is not whole: a file beside it cannot be loaded.";

// The mark on top is the middle of the picture. It is no north, which data need not have.
const COMPASS = `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 100 100" fill="none">
  <circle cx="50" cy="50" r="47" stroke="rgba(255,255,255,.7)" stroke-width="2" fill="rgba(61,61,61,.5)"/>
  <path d="M50 3l5 11h-10z" fill="#fff"/></svg>`;

const waiting = {}; // name of a file -> who waits for it
const addresses = {}; // name of a file -> where it is

// Takes the bytes of a file as a data URL, from the file's twin NAME.js. A browser lets no page that
// was opened as a file read other files, except scripts.
function file(name, data) {
  const [head, text] = data.split(",");
  const bytes = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
  addresses[name] = URL.createObjectURL(new Blob([bytes], { type: /:(.*?);/.exec(head)[1] }));
  waiting[name]?.(addresses[name]);
}

function loadTwin(name) {
  return new Promise((resolve, reject) => {
    waiting[name] = resolve;
    const script = document.createElement("script");
    script.src = name + ".js";
    script.onerror = () => reject(new Error(name + ".js is missing"));
    script.onload = () => script.remove();
    document.head.append(script);
  });
}

// Resolves to an address from which the viewer can read a file of the page.
async function addressOf(name) {
  if (location.protocol === "file:") {
    addresses[name] ??= loadTwin(name);
  }
  return addresses[name] ?? name;
}

// Makes the viewer load files of the page by their names.
function loadByName(loader) {
  for (const method of ["loadFile", "loadImage"]) {
    const load = loader[method].bind(loader);
    loader[method] = async (name, ...more) => load(await addressOf(name), ...more);
  }
}

// Web servers that send no parts of files let nobody move the slider, so the film is loaded as a whole.
async function filmAddress(name) {
  const address = await addressOf(name);
  if (address !== name) {
    return address;
  }
  const part = await fetch(name, { headers: { Range: "bytes=0-1" } });
  return part.status === 206 ? name : URL.createObjectURL(await part.blob());
}

function say(sentence) {
  const line = document.createElement("p");
  line.className = "widefov-sentence";
  line.textContent = sentence;
  document.getElementById("view").append(line);
}

async function addImage(name, style, text) {
  const image = document.createElement("img");
  image.className = style;
  image.alt = text;
  image.src = await addressOf(name);
  document.getElementById("view").append(image);
}

// The picture, or the film, as it is.
async function addFlat(page) {
  if (!page.film) {
    await addImage(page.picture, "widefov-flat", page.title);
    return;
  }
  const film = document.createElement("video");
  film.className = "widefov-flat";
  film.controls = true;
  film.loop = true;
  film.src = await addressOf(page.film);
  document.getElementById("view").append(film);
}

function tiled(page) {
  const levels = page.tiles.map(({ width, columns }) => ({ width, cols: columns, rows: columns / 2 }));
  const tileUrl = (column, row, level) => `tiles/${level}-${column}-${row}.jpg`;
  return { levels, tileUrl, baseUrl: page.picture };
}

async function panoramaOf(page) {
  if (page.film) {
    return { source: await filmAddress(page.film), data: page.sphere };
  }
  return page.tiles ? tiled(page) : { path: page.picture, data: page.sphere };
}

function adapterOf(page) {
  if (page.film) {
    return EquirectangularVideoAdapter.withConfig({ shader: true, autoplay: true, muted: true });
  }
  return page.tiles ? EquirectangularTilesAdapter.withConfig({ baseBlur: false })
    : EquirectangularAdapter.withConfig({ shader: true, useXmpData: false });
}

function buttonsOf(page) {
  return ["zoom", "move", ...(page.film ? ["videoPlay", "videoVolume", "videoTime"] : []), "fullscreen"];
}

function makeViewer(page) {
  const plugins = [CompassPlugin.withConfig({ backgroundSvg: COMPASS, position: "top right", size: "80px" })];
  if (page.film) {
    plugins.push(VideoPlugin.withConfig({ bigbutton: false }));
  }
  return new Viewer({
    container: "view", adapter: adapterOf(page), plugins, keyboard: "always", moveInertia: 0,
    navbar: buttonsOf(page), loadingTxt: "", maxFov: 110,
  });
}

function addTitle(page) {
  const title = document.createElement("h1");
  title.textContent = page.title;
  document.getElementById("view").append(title);
}

// Puts what is in the page onto the viewer, so that it is seen on a full screen, too.
function moveInto(viewer) {
  viewer.container.append(...document.querySelectorAll("#view > h1, #view > .widefov-bar"));
}

async function turn(viewer, page) {
  loadByName(viewer.textureLoader);
  if (page.bar) {
    await addImage(page.bar, "widefov-bar", "bar of colours");
  }
  moveInto(viewer);
  await viewer.setPanorama(await panoramaOf(page), { showLoader: false });
  viewer.setOption("navbar", [...buttonsOf(page), ...await headsetButtons(viewer, page)]);
}

// Shows a page: its title; sphere, the part of all directions in the picture; the names of the picture
// or the film, of the picture of the right eye, and of the bar of colours; tiles, the sizes of a picture in
// tiles.
async function show(page) {
  document.title = page.title;
  addTitle(page);
  if (!document.createElement("canvas").getContext("webgl2")) {
    say(NO_WEBGL);
    await addFlat(page);
    return;
  }
  const viewer = makeViewer(page);
  window.widefov.viewer = viewer;
  try {
    await turn(viewer, page);
  } catch (error) {
    console.error(error);
    viewer.destroy();
    document.getElementById("view").replaceChildren();
    addTitle(page);
    say(page.film ? CANNOT_PLAY : CANNOT_LOAD);
  }
}

window.widefov = { file, show };

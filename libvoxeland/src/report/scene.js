// The 3D view, after table.js.
let chosen = null;  // an object
fillPage();
makeTable();

// ---- voxels -----------------------------------------------------------------------------------

function decode(text, Type) {
  const bytes = Uint8Array.from(atob(text), c => c.charCodeAt(0));
  return new Type(bytes.buffer);
}

const voxels = {
  count: data.voxels,
  positions: decode(data.positions, Uint16Array),
  owners: decode(data.owners, Uint32Array),
  doubts: decode(data.doubts, Uint8Array)
};

const RAMP = data.ramp.map(c => new THREE.Color(c));
const UNKNOWN = new THREE.Color(data.unknown);
const onRamp = share => RAMP[Math.round(Math.min(1, share) * (RAMP.length - 1))];

// Colour of a voxel, by what is shown.
const COLORINGS = {
  instance: owners(object => new THREE.Color(object.color)),
  category: owners(object => new THREE.Color(object.categoryColor)),
  entropy: owners(object => onRamp(object.entropy / data.scale)),
  doubt: voxel => voxels.owners[voxel] || voxels.doubts[voxel] ? onRamp(voxels.doubts[voxel] / 255) : UNKNOWN
};

function owners(colorOf) {
  const colors = [UNKNOWN].concat(data.instances.map(colorOf));
  return voxel => colors[voxels.owners[voxel]];
}

// ---- the scene: x to the right, y up ------------------------------------------------------------

const [levelX, levelY, levelZ] = data.axes;
const toScene = new THREE.Matrix4().set(
  levelX[0], levelX[1], levelX[2], 0,
  levelZ[0], levelZ[1], levelZ[2], 0,
  -levelY[0], -levelY[1], -levelY[2], 0,
  0, 0, 0, 1);
const inScene = p => new THREE.Vector3(p[0], p[1], p[2]).applyMatrix4(toScene);
const centerOf = voxel => [0, 1, 2].map(
  a => (data.origin[a] + voxels.positions[3 * voxel + a] + 0.5) * data.resolution);

const renderer = new THREE.WebGLRenderer({canvas: element('canvas'), antialias: true, preserveDrawingBuffer: true});
renderer.setPixelRatio(window.devicePixelRatio);
renderer.setClearColor(0xffffff);
renderer.localClippingEnabled = true;
const scene = new THREE.Scene();
const camera = new THREE.PerspectiveCamera(45, 1, 0.05, 1000);
const controls = new THREE.OrbitControls(camera, renderer.domElement);
scene.add(new THREE.HemisphereLight(0xffffff, 0xb0b4bc, 0.75));
for (const [strength, x, y, z] of [[0.35, 1, 2, 0.5], [0.15, -1, 0.3, -0.6]]) {
  const light = new THREE.DirectionalLight(0xffffff, strength);
  light.position.set(x, y, z);
  scene.add(light);
}

// Cubes of the voxels that satisfy a condition.
function cubesOf(wanted) {
  const members = [];
  for (let i = 0; i < voxels.count; ++i) if (wanted(i)) members.push(i);
  const Box = THREE.BoxBufferGeometry || THREE.BoxGeometry;
  const geometry = new Box(data.resolution, data.resolution, data.resolution);
  const colors = new THREE.InstancedBufferAttribute(new Float32Array(3 * members.length), 3);
  geometry.setAttribute('color', colors);
  const material = new THREE.MeshLambertMaterial({vertexColors: THREE.VertexColors || true});
  const mesh = new THREE.InstancedMesh(geometry, material, members.length);
  const matrix = new THREE.Matrix4();
  members.forEach((voxel, i) => {
    matrix.makeTranslation(...centerOf(voxel));
    mesh.setMatrixAt(i, matrix);
  });
  mesh.matrix.copy(toScene);
  mesh.matrixAutoUpdate = false;
  mesh.frustumCulled = false;
  if (members.length > 0) scene.add(mesh);
  return {mesh, members, colors};
}

const objects = cubesOf(voxel => voxels.owners[voxel] > 0);
const surroundings = cubesOf(voxel => voxels.owners[voxel] === 0);
const cutPlane = new THREE.Plane(new THREE.Vector3(0, -1, 0), 0);
surroundings.mesh.material.clippingPlanes = [cutPlane];

// Drawn before translucent surroundings, and only into the depth: what is behind them then shows
// through one layer, not through many.
const veil = new THREE.InstancedMesh(surroundings.mesh.geometry,
  new THREE.MeshBasicMaterial({colorWrite: false, clippingPlanes: [cutPlane]}), surroundings.members.length);
veil.instanceMatrix = surroundings.mesh.instanceMatrix;
veil.matrix.copy(toScene);
veil.matrixAutoUpdate = false;
veil.frustumCulled = false;
veil.renderOrder = 1;
if (surroundings.members.length > 0) scene.add(veil);

const boxMaterial = new THREE.LineBasicMaterial({color: 0x1d2530});
const chosenBox = new THREE.LineSegments(
  new THREE.EdgesGeometry(new (THREE.BoxBufferGeometry || THREE.BoxGeometry)(1, 1, 1)), boxMaterial);
chosenBox.matrixAutoUpdate = false;
chosenBox.visible = false;
scene.add(chosenBox);

function quantile(values, share) {
  const sorted = Float64Array.from(values).sort();
  return sorted.length ? sorted[Math.round(share * (sorted.length - 1))] : 0;
}

// What the view is centred on: all but a few strays, of the objects if there are any.
function extentOf(members) {
  const points = members.map(voxel => inScene(centerOf(voxel)));
  const box = new THREE.Box3();
  for (const share of [0.01, 0.99])
    box.expandByPoint(new THREE.Vector3(...['x', 'y', 'z'].map(a => quantile(points.map(p => p[a]), share))));
  return box;
}
const focus = extentOf(objects.members.length ? objects.members : surroundings.members);
const room = extentOf(objects.members.concat(surroundings.members));

let needsFrame = true;
const redraw = () => { needsFrame = true; };

function paint() {
  const colorOf = COLORINGS[element('coloring').value];
  for (const part of [objects, surroundings]) {
    part.members.forEach((voxel, i) => {
      let {r, g, b} = colorOf(voxel);
      if (chosen && data.instances[voxels.owners[voxel] - 1] !== chosen)
        [r, g, b] = [r, g, b].map(c => 0.8 + 0.15 * c);
      part.colors.setXYZ(i, r, g, b);
    });
    part.colors.needsUpdate = true;
  }
  const kind = element('surroundings').value;
  const material = surroundings.mesh.material;
  surroundings.mesh.visible = kind !== 'none';
  material.transparent = kind === 'faint';
  material.opacity = kind === 'faint' ? 0.45 : 1;
  veil.visible = kind === 'faint';
  material.needsUpdate = true;
  showLegend();
  redraw();
}

function cut() {
  const share = Number(element('cut').value);
  cutPlane.constant = room.min.y + share * (room.max.y - room.min.y) + data.resolution;
  redraw();
}

function lookAt(box, distance) {
  const middle = box.getCenter(new THREE.Vector3());
  const reach = distance / Math.min(1, camera.aspect) * Math.max(0.5, box.getSize(new THREE.Vector3()).length());
  const elevation = 50 * Math.PI / 180, {azimuth} = data;
  const direction = new THREE.Vector3(Math.cos(elevation) * Math.cos(azimuth), Math.sin(elevation),
    -Math.cos(elevation) * Math.sin(azimuth));
  controls.target.copy(middle);
  camera.position.copy(middle).addScaledVector(direction, reach);
  camera.near = reach / 100;
  camera.far = reach * 100;
  camera.updateProjectionMatrix();
  controls.update();
  redraw();
}

// ---- names in the scene -------------------------------------------------------------------------

const LABELLED = 8;  // voxels
const labels = data.instances.filter(object => object.voxels >= LABELLED).map(object => {
  const span = add(element('labels'), 'span', nameOf(object));
  return {object, span, middle: inScene(object.centroid)};
});

// The biggest objects come first; a name that would cover another one moves a little, or is left out.
function placeLabels() {
  const canvas = renderer.domElement, taken = [];
  for (const {object, span, middle} of labels) {
    const p = middle.clone().project(camera);
    const x = (p.x + 1) / 2 * canvas.clientWidth, y = (1 - p.y) / 2 * canvas.clientHeight;
    const half = 3.6 * nameOf(object).length + 7, height = 20;
    const isFree = place => !taken.some(t => Math.abs(t.x - x) < t.half + half && Math.abs(t.y - place) < height);
    const place = [0, -1, 1, -2, 2].map(rows => y + rows * height).find(isFree) || (object === chosen ? y : undefined);
    const shown = element('names').checked && p.z < 1 && place !== undefined;
    span.hidden = !shown;
    if (!shown) continue;
    taken.push({x, y: place, half});
    span.style.left = x + 'px';
    span.style.top = place + 'px';
    span.style.borderColor = element('coloring').value === 'category' ? object.categoryColor : object.color;
    span.style.opacity = chosen && object !== chosen ? 0.45 : 1;
  }
}

function showLegend() {
  const legend = element('legend');
  legend.textContent = '';
  const kind = element('coloring').value;
  if (kind === 'entropy' || kind === 'doubt') {
    add(legend, 'div', kind === 'entropy' ? 'which category is the object?' : 'which object is the voxel part of?');
    add(legend, 'div', undefined, 'bar').style.background = 'linear-gradient(to right,' + data.ramp.join(',') + ')';
    const ends = add(legend, 'div', undefined, 'ends');
    add(ends, 'span', 'sure: 0');
    add(ends, 'span', data.scale.toFixed(2) + ' nat: unsure');
  } else {
    const entries = new Map();
    for (const object of data.instances)
      if (kind === 'category') {
        const known = entries.get(object.category) || {color: object.categoryColor, count: 0};
        ++known.count;
        entries.set(object.category, known);
      } else if (entries.size < 10) {
        entries.set(nameOf(object), {color: object.color, count: 1});
      }
    for (const [name, {color, count}] of entries) {
      const entry = add(legend, 'div', undefined, 'entry');
      swatch(entry, color);
      add(entry, 'span', count > 1 ? name + ' (' + count + ')' : name);
    }
  }
  const entry = add(legend, 'div', undefined, 'entry');
  swatch(entry, data.unknown);
  add(entry, 'span', 'no object');
}

// ---- pointing and choosing ------------------------------------------------------------------------

// The object under the pointer, or null: the nearest of its cubes that the ray meets.
const raycaster = new THREE.Raycaster();
const fromScene = new THREE.Matrix4().copy(toScene).transpose();
function objectAt(event) {
  const canvas = renderer.domElement.getBoundingClientRect();
  raycaster.setFromCamera({
    x: (event.clientX - canvas.left) / canvas.width * 2 - 1,
    y: 1 - (event.clientY - canvas.top) / canvas.height * 2
  }, camera);
  const ray = raycaster.ray.clone().applyMatrix4(fromScene);
  const half = data.resolution / 2, box = new THREE.Box3(), hit = new THREE.Vector3();
  let nearest = Infinity, found = null;
  const solid = element('surroundings').value === 'solid';
  for (const part of solid ? [objects, surroundings] : [objects])
    for (const voxel of part.members) {
      const c = centerOf(voxel);
      if (part === surroundings && cutPlane.distanceToPoint(inScene(c)) < 0) continue;
      box.min.set(c[0] - half, c[1] - half, c[2] - half);
      box.max.set(c[0] + half, c[1] + half, c[2] + half);
      if (!ray.intersectBox(box, hit)) continue;
      const distance = hit.distanceToSquared(ray.origin);
      if (distance < nearest) [nearest, found] = [distance, data.instances[voxels.owners[voxel] - 1] || null];
    }
  return found;
}

function choose(object, move) {
  chosen = object;
  for (const row of element('table').tBodies[0].rows) {
    row.classList.toggle('chosen', row.object === chosen);
    if (row.object === chosen) row.scrollIntoView({block: 'nearest'});
  }
  chosenBox.visible = Boolean(chosen);
  if (chosen) {
    const {center, size, axes} = chosen.box;
    const turn = new THREE.Matrix4().makeBasis(...axes.map(a => new THREE.Vector3(...a)));
    chosenBox.matrix.copy(toScene).multiply(new THREE.Matrix4().makeTranslation(...center)).multiply(turn)
      .scale(new THREE.Vector3(...size));
    if (move) {
      const from = camera.position.clone().sub(controls.target).normalize();
      const middle = inScene(center);
      controls.target.copy(middle);
      camera.position.copy(middle).addScaledVector(from, 1.8 + 2 * Math.max(...size));
      controls.update();
    }
  }
  showDetail();
  paint();
}

function showDetail() {
  const detail = element('detail');
  detail.textContent = '';
  if (!chosen) {
    detail.textContent = 'Click an object to see how sure the map is of it.';
    return;
  }
  add(detail, 'b', nameOf(chosen));
  add(detail, 'span', ': seen ' + chosen.observations + ' times, ' + chosen.voxels + ' voxels, ' +
    chosen.box.size.map(s => s.toFixed(2)).join(' x ') + ' m at (' +
    chosen.at.map(c => c.toFixed(2)).join(', ') + ')');
  for (const [name, probability] of chosen.probabilities) {
    const row = add(detail, 'div', undefined, 'row');
    meter(row, probability);
    add(row, 'span', percent(probability) + ' ' + name);
  }
}

let pressed = null;
const canvas = renderer.domElement;
canvas.addEventListener('pointerdown', event => { pressed = [event.clientX, event.clientY]; });
canvas.addEventListener('click', event => {
  if (pressed && Math.hypot(event.clientX - pressed[0], event.clientY - pressed[1]) < 4) choose(objectAt(event), false);
});
canvas.addEventListener('pointermove', event => {
  const tip = element('tip'), object = event.buttons ? null : objectAt(event);
  tip.hidden = !object;
  if (!object) return;
  tip.textContent = nameOf(object) + ': ' + percent(object.probability) + ' ' + object.category +
    ', entropy ' + object.entropy.toFixed(2) + ' nat, seen ' + object.observations +
    (object.observations === 1 ? ' time' : ' times');
  const frame = canvas.getBoundingClientRect();
  tip.style.left = Math.min(event.clientX - frame.left + 14, frame.width - 220) + 'px';
  tip.style.top = event.clientY - frame.top + 14 + 'px';
});
canvas.addEventListener('pointerleave', () => { element('tip').hidden = true; });

function resize() {
  const {clientWidth, clientHeight} = element('scene');
  renderer.setSize(clientWidth, clientHeight, false);
  camera.aspect = clientWidth / clientHeight;
  camera.updateProjectionMatrix();
  redraw();
}

function frame() {
  window.requestAnimationFrame(frame);
  if (!needsFrame) return;
  needsFrame = false;
  renderer.render(scene, camera);
  placeLabels();
  document.body.dataset.rendered = 'yes';
}

for (const id of ['coloring', 'surroundings', 'names']) element(id).addEventListener('change', paint);
element('cut').addEventListener('input', cut);
element('home').addEventListener('click', () => { choose(null); lookAt(focus, 1.4); });
controls.addEventListener('change', redraw);
window.addEventListener('resize', resize);
// Ceilings, and walls above the objects, must not hide them.
const height = room.max.y - room.min.y;
element('cut').value = height > 0 && objects.members.length ? (focus.max.y - room.min.y) / height : 1;
cut();
paint();
resize();
lookAt(focus, 1.4);
frame();

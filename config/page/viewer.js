// The 3D view: cloud, dense cloud or mesh, paths, cameras, overlaps; z is up.
'use strict';
const SESSION_COLORS = ['#d1495b', '#2f6f9f', '#3c9d6b', '#e0a030', '#7d5ba6', '#3aa6a6', '#b0643a', '#8a8f98'];

function bytesOf(base64) {
  const text = atob(base64), bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  return bytes;
}

function colorOf(index) {
  return new THREE.Color(SESSION_COLORS[index % SESSION_COLORS.length]);
}

function geometryOf(part) {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.BufferAttribute(new Float32Array(bytesOf(part.positions).buffer), 3));
  geometry.setAttribute('color', new THREE.BufferAttribute(bytesOf(part.colors), 3, true));
  return geometry;
}

function pointsOf(part, size) {
  const material = new THREE.PointsMaterial({size: size, vertexColors: THREE.VertexColors, sizeAttenuation: true});
  return new THREE.Points(geometryOf(part), material);
}

function sessionPoints(part, size) {
  const sessions = bytesOf(part.sessions), colors = new Uint8Array(3 * sessions.length);
  sessions.forEach((session, i) => {
    const color = colorOf(session);
    colors.set([255 * color.r, 255 * color.g, 255 * color.b], 3 * i);
  });
  const points = pointsOf(part, size);
  points.geometry.setAttribute('color', new THREE.BufferAttribute(colors, 3, true));
  return points;
}

function meshOf(part) {
  const geometry = geometryOf(part);
  geometry.setIndex(new THREE.BufferAttribute(new Uint32Array(bytesOf(part.indices).buffer), 1));
  return new THREE.Mesh(geometry, new THREE.MeshBasicMaterial({vertexColors: THREE.VertexColors, side: THREE.DoubleSide}));
}

function linesOf(corners, color) {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.BufferAttribute(new Float32Array(corners), 3));
  return new THREE.LineSegments(geometry, new THREE.LineBasicMaterial({color: color}));
}

function pathLines(path) {
  const corners = [];
  for (let i = 1; i < path.poses.length; ++i) corners.push(...path.poses[i - 1].slice(0, 3), ...path.poses[i].slice(0, 3));
  return corners;
}

// A pyramid for every keyframe, at most 400 a session.
function frusta(path, size) {
  const corners = [], keyframes = path.poses.filter((_, i) => path.keyframes[i]);
  const step = Math.ceil(keyframes.length / 400) || 1;
  const rim = [[-0.8, -0.6, 1], [0.8, -0.6, 1], [0.8, 0.6, 1], [-0.8, 0.6, 1]];
  for (let i = 0; i < keyframes.length; i += step) {
    const [x, y, z, qx, qy, qz, qw] = keyframes[i], rotation = new THREE.Quaternion(qx, qy, qz, qw);
    const ends = rim.map(end => new THREE.Vector3(...end).multiplyScalar(size).applyQuaternion(rotation)
      .add(new THREE.Vector3(x, y, z)));
    ends.forEach((end, k) => {
      const next = ends[(k + 1) % 4];
      corners.push(x, y, z, end.x, end.y, end.z, end.x, end.y, end.z, next.x, next.y, next.z);
    });
  }
  return corners;
}

// The box that holds most points: what lies far out does not shrink the rest.
function middleBox(positions) {
  const box = {center: new THREE.Vector3(), size: 1};
  if (!positions.length) return box;
  const sizes = [0, 1, 2].map(axis => {
    const values = [];
    for (let i = axis; i < positions.length; i += 3 * Math.ceil(positions.length / 30000)) values.push(positions[i]);
    values.sort((a, b) => a - b);
    const low = values[Math.floor(0.05 * values.length)], high = values[Math.floor(0.95 * (values.length - 1))];
    box.center.setComponent(axis, (low + high) / 2);
    return high - low;
  });
  box.size = Math.max(...sizes, 1e-3);
  return box;
}

class MapView {
  constructor(canvas, form) {
    this.canvas = canvas;
    this.form = form;
    this.renderer = new THREE.WebGLRenderer({canvas: canvas, antialias: true, alpha: true, preserveDrawingBuffer: true});
    this.renderer.setPixelRatio(window.devicePixelRatio || 1);
    this.scene = new THREE.Scene();
    this.camera = new THREE.PerspectiveCamera(50, 1, 0.01, 1000);
    this.camera.up.set(0, 0, 1);
    this.controls = new THREE.OrbitControls(this.camera, canvas);
    this.controls.addEventListener('change', () => this.drawSoon());
    window.addEventListener('resize', () => this.resize());
    this.layers = {};
    this.due = 0;  // the repaint that drawSoon waits for
  }

  // Replaces a layer; its switch stays as it was. Returns what holds the objects.
  setLayer(name, objects, isShown, color) {
    const old = this.layers[name];
    if (old) this.forget(old.group);
    const group = new THREE.Group();
    objects.forEach(object => group.add(object));
    group.visible = old ? old.box.checked : isShown;
    this.scene.add(group);
    this.layers[name] = {group: group, box: old ? old.box : this.addSwitch(name, isShown, color)};
    return group;
  }

  removeLayer(name) {
    const old = this.layers[name];
    if (!old) return;
    this.forget(old.group);
    old.box.parentElement.remove();
    delete this.layers[name];
  }

  // Buffers of the graphics card are freed by hand.
  forget(group) {
    this.scene.remove(group);
    group.traverse(object => {
      if (object.geometry) object.geometry.dispose();
      if (object.material && object.material.map) object.material.map.dispose();
      if (object.material) object.material.dispose();
    });
  }

  addSwitch(name, isShown, color) {
    const label = document.createElement('label'), box = document.createElement('input');
    box.type = 'checkbox';
    box.checked = isShown;
    box.addEventListener('change', () => {
      this.layers[name].group.visible = box.checked;
      this.draw();
    });
    label.append(box, ' ' + name);
    if (color) {
      const swatch = document.createElement('span');
      swatch.className = 'swatch';
      swatch.style.background = color;
      label.append(swatch);
    }
    this.form.append(label);
    return box;
  }

  lookAt(box) {
    this.controls.target.copy(box.center);
    this.camera.position.copy(box.center).add(new THREE.Vector3(-0.75, -0.5, 0.65).multiplyScalar(box.size));
    this.camera.near = box.size / 500;
    this.camera.far = box.size * 50;
    this.controls.update();
  }

  resize() {
    const width = this.canvas.clientWidth, height = this.canvas.clientHeight;
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.draw();
  }

  // Once before the next repaint, however often it is asked for.
  drawSoon() {
    if (!this.due) this.due = requestAnimationFrame(() => this.draw());
  }

  draw() {
    cancelAnimationFrame(this.due);
    this.due = 0;
    this.renderer.render(this.scene, this.camera);
  }
}

function showMap(view, data) {
  const box = middleBox(new Float32Array(bytesOf(data.cloud.positions).buffer)), size = box.size / 160;
  const hasMore = Boolean(data.dense || data.mesh);
  if (data.mesh) view.setLayer('surface', [meshOf(data.mesh)], true);
  if (data.dense) view.setLayer('dense cloud', [pointsOf(data.dense, size * 1.2)], !data.mesh);
  view.setLayer('landmarks', [pointsOf(data.cloud, size)], !hasMore);
  if (data.paths.length > 1) view.setLayer('landmarks by session', [sessionPoints(data.cloud, size)], false);
  data.paths.forEach((path, i) => {
    const color = colorOf(i);
    view.setLayer(`${path.drive}, session ${path.session}`,
                  [linesOf(pathLines(path), color), linesOf(frusta(path, box.size / 60), color)],
                  true, SESSION_COLORS[i % SESSION_COLORS.length]);
  });
  if (data.overlaps.length) view.setLayer('overlaps', [linesOf(data.overlaps.flat(), new THREE.Color('#c98a1b'))], true);
  view.lookAt(box);
  view.resize();
}

function tellError(error) {
  const place = document.getElementById('view-error');
  place.textContent = `No 3D view: ${error.message}`;
  place.hidden = false;
}

(function main() {
  const data = JSON.parse(document.getElementById('data').textContent);
  if (data.live) return;  // live.js fetches its own
  showFigures(data);
  try {
    window.mapView = new MapView(document.getElementById('canvas'), document.getElementById('layers'));
    showMap(window.mapView, data);
  } catch (error) {
    tellError(error);
  }
  document.body.dataset.shown = 'yes';
})();

// The page that map_web serves: asks for what changed, once a second, and shows it.
'use strict';
const PERIOD_MS = 1000, MAX_GROWTH = 120;
const ACCEPTED_COLOR = '#1fb5b5', PROVISIONAL_COLOR = '#c240c2';

function floatsOf(base64) {
  return new Float32Array(bytesOf(base64).buffer);
}

// Fetches what is new since it was last asked; null where nothing is.
class Feed {
  constructor(path) {
    this.path = path;
    this.revision = '';
  }

  async take(read) {
    const reply = await fetch(this.path + '?since=' + encodeURIComponent(this.revision), {cache: 'no-store'});
    if (!reply.ok) throw new Error(`${this.path}: ${await reply.text()}`);
    if (reply.status === 204) return null;
    const taken = await read(reply);
    this.revision = reply.headers.get('X-Revision');
    return taken;
  }
}

function textSprite(shape) {
  const canvas = document.createElement('canvas'), context = canvas.getContext('2d'), font = '48px sans-serif';
  context.font = font;
  canvas.width = Math.ceil(context.measureText(shape.text).width) + 8;
  canvas.height = 64;
  context.font = font;
  context.fillStyle = getComputedStyle(document.body).color;
  context.fillText(shape.text, 4, 48);
  const sprite = new THREE.Sprite(new THREE.SpriteMaterial({map: new THREE.CanvasTexture(canvas)}));
  sprite.material.map.minFilter = THREE.LinearFilter;
  sprite.scale.set(shape.height * canvas.width / canvas.height, shape.height, 1);
  sprite.position.set(...shape.at);
  return sprite;
}

// Of a visualization_msgs/Marker; null for other types.
function shapeObject(shape, size) {
  if (shape.type === 9) return textSprite(shape);
  const color = new THREE.Color(...shape.color.map(channel => channel / 255));
  if (shape.type === 8 && shape.colors) return pointsOf(shape, size);
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.BufferAttribute(floatsOf(shape.positions), 3));
  const material = new THREE.LineBasicMaterial({color: color});
  if (shape.type === 4) return new THREE.Line(geometry, material);
  return shape.type === 5 ? new THREE.LineSegments(geometry, material) : null;
}

function place(group, pose) {
  group.position.set(pose[0], pose[1], pose[2]);
  group.quaternion.set(pose[3], pose[4], pose[5], pose[6]);
}

class LivePage {
  constructor(settings) {
    this.settings = settings;
    this.feeds = {status: new Feed('/api/status'), cloud: new Feed('/api/cloud'), scene: new Feed('/api/paths')};
    this.scene = {};
    this.cloud = {count: 0, total: 0, positions: '', colors: '', sessions: '', views: ''};
    this.status = {root: 0, unit: 'map units', figures: {}, warnings: [], sessions: [], merges: []};
    this.growth = [];
    this.size = 1 / 160;
    this.shownSessions = new Map();  // {layer, state} by number
    this.view = new MapView(document.getElementById('canvas'), document.getElementById('layers'));
    this.view.controls.addEventListener('start', () => { this.isTurned = true; });
    this.addFitButton();
    this.cameras = settings.robots.map(robot => this.addCamera(robot));
    if (settings.control) this.addControl();
  }

  addFitButton() {
    const button = document.createElement('button');
    button.type = 'button';
    button.textContent = 'Show all';
    button.addEventListener('click', () => {
      this.isTurned = false;
      this.fit();
    });
    this.view.form.append(button);
  }

  addCamera(robot) {
    const figure = document.createElement('figure'), image = document.createElement('img');
    const caption = document.createElement('figcaption');
    caption.textContent = robot;
    image.alt = `no picture of ${robot} yet`;
    figure.append(image, caption);
    document.getElementById('cameras').append(figure);
    return {image: image, feed: new Feed(`/api/camera/${robot}.jpg`)};
  }

  async takeCamera(camera) {
    const blob = await camera.feed.take(reply => reply.blob());
    if (!blob) return;
    if (camera.image.src) URL.revokeObjectURL(camera.image.src);
    camera.image.src = URL.createObjectURL(blob);
  }

  async poll() {
    const takeJson = feed => feed.take(reply => reply.json());
    const results = await Promise.allSettled([takeJson(this.feeds.status), takeJson(this.feeds.scene),
      takeJson(this.feeds.cloud), ...this.cameras.map(camera => this.takeCamera(camera))]);
    const [status, scene, cloud] = results.map(result => result.value);
    if (status) this.status = status;
    if (cloud) this.cloud = cloud;
    const changed = scene ? this.takeScene(scene) : new Set();
    if (cloud) this.showCloud();
    if (status || scene) this.showSessions(changed, Boolean(status));
    if (cloud) this.fit();
    if (status || scene || cloud) this.view.draw();
    if (status || cloud) this.showData();
    const failed = results.find(result => result.status === 'rejected');  // what came is shown all the same
    if (failed) throw failed.reason;
  }

  // The names of the parts that changed or went.
  takeScene(scene) {
    const names = new Set(scene.names);
    const gone = Object.keys(this.scene).filter(name => !names.has(name));
    gone.forEach(name => delete this.scene[name]);
    Object.assign(this.scene, scene.changed);
    return new Set([...gone, ...Object.keys(scene.changed)]);
  }

  showCloud() {
    this.view.setLayer('landmarks', [pointsOf(this.cloud, this.size)], true);
    this.view.setLayer('landmarks by session', [sessionPoints(this.cloud, this.size)], false);
  }

  // Most landmarks, and all paths.
  fit() {
    const box = middleBox(floatsOf(this.cloud.positions));
    this.size = box.size / 130;
    if (this.isTurned || !this.cloud.count) return;
    const half = new THREE.Vector3().setScalar(box.size / 2);
    const all = new THREE.Box3(box.center.clone().sub(half), box.center.clone().add(half));
    for (const {layer} of this.shownSessions.values()) all.expandByObject(this.view.layers[layer].group);
    const size = all.getSize(new THREE.Vector3());
    this.view.lookAt({center: all.getCenter(new THREE.Vector3()), size: 0.8 * Math.max(size.x, size.y, size.z)});
  }

  // Of the map that the cloud shows; those of other maps stand in "maps apart".
  showSessions(changed, hasStatus) {
    const here = this.status.sessions.filter(session => session.map === this.status.root);
    const ids = new Set(here.map(session => session.session));
    for (const [id, {layer}] of this.shownSessions) {
      if (ids.has(id)) continue;
      this.view.removeLayer(layer);
      this.shownSessions.delete(id);
    }
    const isStale = ({session: id, state}) => (this.shownSessions.get(id) || {}).state !== state ||
      [`cameras/session_${id}`, `paths/path_${id}`, `place/${id}`, `pose/${id}`].some(name => changed.has(name));
    here.filter(isStale).forEach(session => this.showSession(session));
    if (hasStatus || [...changed].some(name => name.includes('overlaps') || name.startsWith('place/'))) this.showOverlaps(ids);
    if (changed.has('apart')) this.showApart();
  }

  showSession(session) {
    const id = session.session, placeInMap = this.scene[`place/${id}`];
    if (!placeInMap) return;
    const color = colorOf(id - 1), objects = [];
    for (const name of [`paths/path_${id}`, `cameras/session_${id}`]) {
      const shape = this.scene[name];
      const object = shape && shapeObject(shape, this.size);
      if (object) object.material.color = color;
      if (object) objects.push(object);
    }
    const isDriven = session.state === 'maps' || 'images localized' in this.status.figures;
    if (isDriven && this.scene[`pose/${id}`]) objects.push(this.robotNow(this.scene[`pose/${id}`], color));
    const layer = `${session.robot}, session ${id}`;
    place(this.view.setLayer(layer, objects, true, SESSION_COLORS[(id - 1) % SESSION_COLORS.length]), placeInMap);
    this.shownSessions.set(id, {layer: layer, state: session.state});
  }

  robotNow(pose, color) {
    const ball = new THREE.Mesh(new THREE.SphereGeometry(1.6 * this.size, 16, 12), new THREE.MeshBasicMaterial({color: color}));
    ball.position.set(pose[0], pose[1], pose[2]);
    return ball;
  }

  showOverlaps(ids) {
    for (const [kind, label, color] of [['overlaps', 'overlaps', ACCEPTED_COLOR],
                                        ['provisional_overlaps', 'overlaps that wait', PROVISIONAL_COLOR]]) {
      const groups = [...ids].map(id => [this.scene[`cameras/${kind}_${id}`], this.scene[`place/${id}`]])
        .filter(([shape, pose]) => shape && pose).map(([shape, pose]) => {
          const object = shapeObject(shape, this.size);
          object.material.color = new THREE.Color(color);
          place(object, pose);
          return object;
        });
      if (groups.length) this.view.setLayer(label, groups, true, color);
      else this.view.removeLayer(label);
    }
  }

  showApart() {
    const objects = (this.scene.apart || []).map(shape => shapeObject(shape, this.size)).filter(object => object);
    if (objects.length) this.view.setLayer('maps apart', objects, true);
    else this.view.removeLayer('maps apart');
  }

  showData() {
    const sessions = this.status.sessions, views = bytesOf(this.cloud.views), tracks = new Array(29).fill(0);
    views.forEach(count => { if (count >= 2) ++tracks[Math.min(count, 30) - 2]; });
    showFigures({map: this.status.root || '–', unit: this.status.unit, figures: {images: 0, ...this.status.figures},
                 warnings: this.status.warnings, tracks: tracks, errors: [], views: [], stages: [],
                 merges: this.status.merges, paths: sessions.filter(session => session.map === this.status.root),
                 cloud: {count: this.cloud.total}});
    fillTable(document.getElementById('sessions'), ['', 'robot', 'map', 'state', 'keyframes', 'images'],
              sessions.map(session => [String(session.session), session.robot, String(session.map), session.state,
                                       String(session.keyframes), String(session.images)]));
    this.growth = [...this.growth, this.cloud.total].slice(-MAX_GROWTH);
    barChart(document.getElementById('growth'), this.growth, ['', 'now'], 'landmarks');
    if (this.settings.control) this.offerChoices();
  }

  addControl() {
    const given = new URLSearchParams(window.location.hash.slice(1)).get('token');
    if (given) {
      document.getElementById('token').value = given;
      history.replaceState(null, '', window.location.pathname);  // not in bookmarks, nor on a screen that others see
    }
    const card = document.getElementById('control');
    card.hidden = false;
    card.querySelectorAll('form').forEach(form => form.addEventListener('submit', event => {
      event.preventDefault();
      if (form.dataset.service) this.order(form);
    }));
  }

  offerChoices() {
    const numbers = this.status.sessions.map(session => String(session.session));
    const robots = [...new Set(this.status.sessions.filter(session => session.state === 'maps').map(session => session.robot))];
    document.querySelectorAll('#control select').forEach(select => {
      const wanted = select.name === 'robot' ? robots : numbers;
      if ([...select.options].map(option => option.value).join() === wanted.join()) return;
      const chosen = select.value;
      select.replaceChildren(...wanted.map(value => new Option(value, value)));
      if (wanted.includes(chosen)) select.value = chosen;
    });
  }

  async order(form) {
    const said = document.getElementById('said'), fields = {};
    for (const field of form.elements) {
      if (!field.name) continue;
      fields[field.name] = field.type === 'checkbox' ? field.checked
        : field.dataset.type === 'number' ? Number(field.value) : field.value;
    }
    said.textContent = '…';
    try {
      const reply = await fetch('/api/' + form.dataset.service, {
        method: 'POST', body: JSON.stringify(fields),
        headers: {'Content-Type': 'application/json', 'X-Rovio-Token': document.getElementById('token').value}});
      said.textContent = reply.ok ? (await reply.json()).message : await reply.text();
    } catch (error) {
      said.textContent = error.message;
    }
  }
}

function tellState(page) {
  const state = document.getElementById('view-error');
  state.textContent = page.lastError ? `map_web does not answer: ${page.lastError}`
    : page.scene.mapping === false ? 'mapping is not running' : page.cloud.count ? '' : 'no landmarks yet';
  state.hidden = !state.textContent;
}

(async function watch() {
  const settings = JSON.parse(document.getElementById('data').textContent);
  let page;
  try {
    page = new LivePage(settings);
    page.view.resize();
  } catch (error) {
    tellError(error);
    return;
  }
  window.livePage = page;
  window.mapView = page.view;
  for (;;) {
    try {
      await page.poll();
      page.lastError = '';
      document.body.dataset.shown = 'yes';
    } catch (error) {
      page.lastError = error.message;
    }
    tellState(page);
    await new Promise(done => setTimeout(done, PERIOD_MS));
  }
})();

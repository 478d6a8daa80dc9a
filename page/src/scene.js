// The assembly in 3D. Its frame is that of the cam's file: the camshaft is z, to the car's left; x is ahead and y down.
import { swung } from "./motion.js";
import {
  AmbientLight, Box3, BoxGeometry, BufferAttribute, BufferGeometry, Color, CylinderGeometry, DirectionalLight, DoubleSide,
  ExtrudeGeometry, FrontSide, Group, LatheGeometry, LineBasicMaterial, LineSegments, Mesh, MeshLambertMaterial, PerspectiveCamera, Plane,
  Scene, Shape, Sphere, Vector2, Vector3, WebGLRenderer,
} from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";

const css = (name) => new Color(getComputedStyle(document.documentElement).getPropertyValue(name).trim());
const FORK = -1; // in the place of a part's shaft; what stands has -2
const SLOW = 34; // ms from frame to frame beyond which the picture is drawn coarser while it moves
// Shares of the full resolution, from fine to coarse; edges of parts are drawn in the first ones alone.
const LEVELS = [1, 0.8, 0.66, 0.5];
const WITH_EDGES = 2;

export class Assembly {
  constructor(box, motion) {
    this.box = box;
    this.hidden = new Set(); // codes of parts that are not to be seen
    this.software = drawsInSoftware();
    this.renderer = new WebGLRenderer({ antialias: !this.software, powerPreference: "high-performance" });
    this.canvas = this.renderer.domElement;
    box.append(this.canvas);
    this.scene = new Scene();
    this.camera = new PerspectiveCamera(28, 1, 10, 5000);
    this.light = new DirectionalLight(0xffffff, 2.1);
    this.ambient = new AmbientLight(0xffffff, 1.35);
    this.scene.add(this.ambient, this.camera);
    this.camera.add(this.light, this.light.target);
    this.light.position.set(-0.5, 0.9, 1);
    this.light.target.position.set(0, 0, -1);
    this.root = new Group();
    this.root.rotation.x = Math.PI;
    this.scene.add(this.root);
    this.materials = {};
    this.groups = new Map();
    this.cut = new Plane(new Vector3(0, 0, 1), 0);
    this.level = 0; // of the picture now
    this.moving = this.software ? WITH_EDGES : 0; // of the picture while it moves
    this.use(motion);
    this.controls = new OrbitControls(this.camera, this.canvas);
    this.controls.target.copy(this.middle);
    this.controls.enableDamping = false;
    this.controls.addEventListener("change", () => this.ask());
    this.view("start");
    new ResizeObserver(() => this.fit()).observe(box);
    this.fit();
  }

  material(name, options = {}) {
    if (!this.materials[name]) {
      const made = new MeshLambertMaterial({ side: FrontSide, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1, ...options });
      // Inside a cut part its wall's back is seen: painted flat, it looks like the face of the section.
      made.onBeforeCompile = (shader) => {
        shader.fragmentShader = shader.fragmentShader.replace(
          "#include <dithering_fragment>",
          "#include <dithering_fragment>\nif (!gl_FrontFacing) gl_FragColor = vec4(diffuse * 0.62, opacity);",
        );
      };
      this.materials[name] = made;
    }
    return this.materials[name];
  }

  /** Takes a model in place of the one before; the camera, the section and what is hidden stay. */
  use(motion) {
    this.motion = motion;
    for (const meshes of this.groups.values()) {
      for (const mesh of meshes) {
        for (const geometry of new Set([mesh.geometry, mesh.userData.fine, mesh.userData.coarse])) geometry?.dispose();
        for (const lines of mesh.children) lines.geometry.dispose();
      }
    }
    this.root.clear();
    this.groups = new Map();
    this.fork = null;
    this.riders = []; // followers other than the rod, which move as a whole
    this.build();
    for (const code of this.hidden) this.visible(code, false);
    this.colour();
    this.frame();
    if (this.drawnApart) this.explode(this.drawnApart);
    if (this.cutting) this.section(...this.cutting);
    if (this.sized) this.resolve(this.level);
  }

  build() {
    const { shafts, parts, rod, wheel, section, travel, slide, arm, second } = this.motion.scene;
    this.shafts = shafts.map((shaft) => {
      const group = new Group();
      group.position.set(shaft.axis[0], shaft.axis[1], 0);
      this.root.add(group);
      if (shaft.diameter > 0) this.add("shafts", group, rodGeometry(shaft.diameter / 2, shaft.low, shaft.high), "shaft");
      return group;
    });
    const ofFork = parts.some((part) => part.shaft === FORK);
    if (ofFork) {
      this.fork = new Group();
      this.fork.position.set(this.motion.scene.base, 0, rod.height);
      this.root.add(this.fork);
    }
    for (const part of parts) {
      const geometry = partGeometry(part.mesh);
      this.add(part.code, part.shaft === FORK ? this.fork : (this.shafts[part.shaft] ?? this.root), geometry, part.colour);
      const drawnPart = this.groups.get(part.code).at(-1);
      const { userData } = drawnPart;
      [userData.fine, userData.coarse, userData.part] = [geometry, partGeometry(part.coarse), part];
      const lines = new BufferGeometry();
      lines.setAttribute("position", geometry.getAttribute("position"));
      lines.setIndex(new BufferAttribute(part.mesh.edges, 1));
      this.edges ??= new LineBasicMaterial();
      const drawn = new LineSegments(lines, this.edges);
      drawn.raycast = () => {};
      drawnPart.add(drawn);
    }
    if (rod && !ofFork) {
      this.fork = new Group();
      this.fork.position.set(this.motion.scene.base, 0, rod.height);
      const ends = rod.side > 0 ? [0, rod.length] : [-rod.length, 0];
      this.add("follower", this.fork, rodGeometry(rod.radius, ...ends), "rod");
      const post = new CylinderGeometry(4, 4, 34, 40);
      this.add("follower", this.fork, post, "shaft");
      this.root.add(this.fork);
    }
    if (section) {
      const [low, high] = this.thickness();
      const rider = this.ride({ section, travel, arm }, low, high);
      if (slide) this.add("follower", rider, bar([0, 0], [slide.stem - travel.centre[0], 0], slide.half_width, low, high), "rod");
      if (second) this.ride(second, low + second.height, high + second.height, true);
    }
    if (wheel) this.add("wheel", this.shafts[wheel[0]], wheelGeometry(wheel[2]), "wheel", wheel[1]);
  }

  /** A follower that moves as a whole, on a disc between two heights; its arm lies beside the disc, or behind a face. */
  ride({ section, travel, arm }, low, high, second = false) {
    const group = new Group();
    group.position.set(...travel.centre, 0);
    this.root.add(group);
    this.add("follower", group, plate(section, travel.centre, low - 1, high + 1), "rod");
    let lever = null;
    if (arm) {
      lever = new Group();
      lever.position.set(...arm.pivot, 0);
      this.root.add(lever);
      const ends = [[0, 0], ...arm.bends.map(([x, y]) => [x - arm.pivot[0], y - arm.pivot[1]])];
      const [from, to] = ends.length > 2 ? [low, high] : [high + 1, high + 4];
      for (let i = 1; i < ends.length; i++) this.add("follower", lever, bar(ends[i - 1], ends[i], 3, from, to), "shaft");
    }
    this.riders.push({ group, lever, travel, arm, second });
    return group;
  }

  /** Heights between which the disc lies. */
  thickness() {
    const disc = this.motion.scene.parts.find(({ code }) => code === "cam");
    if (!disc) return [0, 1];
    const { low, step } = disc.mesh;
    return [low[2], low[2] + STEPS * step[2]];
  }

  add(code, group, geometry, material, height = 0) {
    const pieces = Array.isArray(geometry) ? geometry : [geometry];
    for (const piece of pieces) {
      const mesh = new Mesh(piece, this.material(material));
      mesh.position.z = height;
      mesh.userData.code = code;
      group.add(mesh);
      if (!this.groups.has(code)) this.groups.set(code, []);
      this.groups.get(code).push(mesh);
    }
  }

  colour() {
    this.renderer.setClearColor(css("--view"));
    for (const [name, material] of Object.entries(this.materials)) material.color.copy(css(`--part-${name}`));
    this.edges?.color.copy(css("--part-edge"));
    this.ask();
  }

  /** The ball around everything: what the first view shows, and how deep the camera looks. */
  frame() {
    const low = new Vector3(Infinity, Infinity, Infinity);
    const high = low.clone().negate();
    this.root.updateWorldMatrix(true, true);
    this.root.traverse((node) => {
      if (!node.isMesh) return;
      if (!node.geometry.boundingBox) node.geometry.computeBoundingBox();
      const box = node.geometry.boundingBox.clone().applyMatrix4(node.matrixWorld);
      low.min(box.min);
      high.max(box.max);
    });
    this.low = low;
    this.high = high;
    this.middle = low.clone().add(high).multiplyScalar(0.5);
    this.size = high.distanceTo(low) / 2;
  }

  /** Looks from a side; `start` is from the right, where the gears of a car are, or on the face that files show. */
  view(name) {
    const from = { start: [0.62, 0.5, this.motion.scene.rod?.side ?? (this.motion.scene.car ? 1 : -1)], left: [0, 0, -1], right: [0, 0, 1], front: [1, 0, 0], top: [0, 1, -0.0001] }[name];
    const toCamera = new Vector3(...from).normalize();
    const half = Math.tan((this.camera.fov * Math.PI) / 360);
    const usual = (this.size * 0.86) / Math.sin(Math.atan(half)) / Math.min(1, this.camera.aspect * 1.05 || 1);
    const away = Math.max(usual, this.least(toCamera, half));
    this.camera.position.copy(this.middle).addScaledVector(toCamera, away);
    this.camera.near = away / 50;
    this.camera.far = away * 4;
    this.camera.updateProjectionMatrix();
    this.controls.target.copy(this.middle);
    this.controls.update();
    this.ask();
  }

  /** Least distance of the camera from which all corners of the model are seen, with a rim of 5 %. */
  least(toCamera, half) {
    const right = new Vector3(0, 1, 0).cross(toCamera).normalize();
    const up = toCamera.clone().cross(right);
    const size = this.high.clone().sub(this.low).multiplyScalar(0.5);
    let away = 0;
    for (const x of [-1, 1])
      for (const y of [-1, 1])
        for (const z of [-1, 1]) {
          const corner = new Vector3(x * size.x, y * size.y, z * size.z);
          const across = Math.max(Math.abs(corner.dot(up)), Math.abs(corner.dot(right)) / (this.camera.aspect || 1));
          away = Math.max(away, corner.dot(toCamera) + (1.05 * across) / half);
        }
    return away;
  }

  /** Turns the camera about the middle, and brings it nearer; angles in rad. */
  orbit(across, up, nearer = 1) {
    const arm = this.camera.position.clone().sub(this.controls.target);
    const radius = arm.length() * nearer;
    const pole = Math.min(Math.max(Math.acos(arm.y / arm.length()) + up, 0.05), Math.PI - 0.05);
    const round = Math.atan2(arm.x, arm.z) + across;
    arm.set(Math.sin(pole) * Math.sin(round), Math.cos(pole), Math.sin(pole) * Math.cos(round));
    this.camera.position.copy(this.controls.target).addScaledVector(arm, radius);
    this.controls.update();
    this.ask();
  }

  fit() {
    const [width, height] = [this.box.clientWidth, this.box.clientHeight];
    if (!width || !height) return;
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.sized = new Vector2(width, height);
    this.resolve(this.level);
  }

  resolve(level) {
    this.level = level;
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2) * LEVELS[level]);
    this.renderer.setSize(this.sized.x, this.sized.y, false);
    const fine = level < WITH_EDGES;
    if (this.edges) this.edges.visible = fine;
    for (const mesh of [...this.groups.values()].flat()) {
      if (mesh.userData.coarse) mesh.geometry = fine ? mesh.userData.fine : mesh.userData.coarse;
    }
    this.ask();
  }

  show(state) {
    this.state = state;
    this.shafts.forEach((group, index) => {
      group.rotation.z = this.motion.shaft(index, state);
      group.position.set(...this.motion.place(index, state), 0);
    });
    for (const { group, lever, travel, arm, second } of this.riders) {
      const way = second ? state.secondWay : state.way;
      group.position.set(travel.centre[0] + way.ahead, travel.centre[1] + way.across, 0);
      group.rotation.z = way.turned;
      if (lever) lever.rotation.z = swung(arm.pivot, travel.centre, way);
    }
    if (this.fork) this.fork.rotation.y = this.motion.scene.rod.side * Math.atan(state.tan);
    this.ask();
  }

  visible(code, on) {
    if (on) this.hidden.delete(code);
    else this.hidden.add(code);
    for (const mesh of this.groups.get(code) ?? []) mesh.visible = on;
    this.ask();
  }

  /** Draws the parts apart by a share of their ways: those on shafts along these, those of the fork upwards. */
  explode(share) {
    this.drawnApart = share;
    for (const mesh of [...this.groups.values()].flat()) {
      const [down, along] = mesh.userData.part?.apart ?? [0, 0];
      if (mesh.userData.part) mesh.position.set(0, share * down, share * along);
    }
    this.frame();
    this.ask();
  }

  /** Cuts everything away on one side of a plane; axis x, y, z of the page or null; share 0 to 1 of the whole. */
  section(axis, share) {
    const on = axis !== null;
    this.cutting = on ? [axis, share] : null;
    if (on) {
      const place = this.low[axis] + share * (this.high[axis] - this.low[axis]);
      // What is on the camera's side goes.
      const sign = this.camera.position[axis] > this.middle[axis] ? -1 : 1;
      this.cut.normal.set(0, 0, 0)[axis] = sign;
      this.cut.constant = -sign * place;
    }
    this.renderer.clippingPlanes = on ? [this.cut] : [];
    for (const material of Object.values(this.materials)) {
      const side = on ? DoubleSide : FrontSide;
      if (material.side !== side) {
        material.side = side;
        material.needsUpdate = true;
      }
    }
    this.ask();
  }

  ask() {
    this.dirty = true;
    this.wake?.();
  }

  /** Draws if something has changed. While it moves, the picture becomes coarser where frames come late. */
  draw(moving, since) {
    if (!this.sized) return;
    if (moving && since !== undefined) {
      this.took = this.took === undefined ? since : 0.8 * this.took + 0.2 * since;
      if (this.took > SLOW && this.moving < LEVELS.length - 1) {
        this.moving += 1;
        this.took = undefined;
      } else if (this.took > SLOW) this.halved = true;
      // At last the assembly moves in each second frame, and all else in every one.
      this.even = !this.even;
      if (this.halved && this.even && this.level === this.moving) return;
    }
    const level = moving ? this.moving : 0;
    if (level !== this.level) this.resolve(level);
    if (!this.dirty) return;
    this.dirty = false;
    this.before?.();
    this.renderer.render(this.scene, this.camera);
  }

  picture() {
    this.resolve(0);
    this.renderer.render(this.scene, this.camera);
    return this.canvas.toDataURL("image/png");
  }
}

/** Whether the browser has no graphics card and draws by the processor. */
function drawsInSoftware() {
  const context = document.createElement("canvas").getContext("webgl2");
  if (!context) throw new Error("no WebGL");
  const known = context.getExtension("WEBGL_debug_renderer_info");
  const name = known ? context.getParameter(known.UNMASKED_RENDERER_WEBGL) : "";
  context.getExtension("WEBGL_lose_context")?.loseContext();
  return /swiftshader|llvmpipe|software|basic render/i.test(name);
}

function rodGeometry(radius, low, high) {
  const geometry = new CylinderGeometry(radius, radius, high - low, 40);
  geometry.rotateX(Math.PI / 2);
  geometry.translate(0, 0, (low + high) / 2);
  return geometry;
}

/** A section of points in the plane between two heights, about its middle. */
function plate(points, [x, y], low, high) {
  const shape = new Shape(points.slice(0, -1).map(([px, py]) => new Vector2(px - x, py - y)));
  return new ExtrudeGeometry(shape, { depth: high - low, bevelEnabled: false }).translate(0, 0, low);
}

/** A bar from one point to another of a plane, between two heights. */
function bar([ax, ay], [bx, by], half, low, high) {
  const length = Math.hypot(bx - ax, by - ay);
  const made = new BoxGeometry(length, 2 * half, high - low).translate(length / 2, 0, (low + high) / 2);
  return made.rotateZ(Math.atan2(by - ay, bx - ax)).translate(ax, ay, 0);
}

/** A wheel through which one sees: rim, hub and five spokes. */
function wheelGeometry(radius) {
  const rim = [[radius - 5, -3], [radius, -3], [radius, 3], [radius - 5, 3], [radius - 5, -3]];
  const hub = [[3, -5], [8, -5], [8, 5], [3, 5], [3, -5]];
  const turned = [rim, hub].map((points) => new LatheGeometry(points.map(([x, y]) => new Vector2(x, y)), 96).rotateX(Math.PI / 2));
  const spokes = Array.from({ length: 5 }, (_, i) => {
    const spoke = new BoxGeometry(radius - 10, 3, 3);
    spoke.translate((radius - 10) / 2 + 6, 0, 0);
    return spoke.rotateZ((i * 2 * Math.PI) / 5);
  });
  return [...turned, ...spokes];
}

const STEPS = 65535; // of a vertex across its part's box

function partGeometry({ low, step, vertices, normals, triangles }) {
  const places = new Float32Array(vertices.length);
  const [[x, y, z], [dx, dy, dz]] = [low, step];
  for (let i = 0; i < places.length; i += 3) {
    places[i] = x + dx * vertices[i];
    places[i + 1] = y + dy * vertices[i + 1];
    places[i + 2] = z + dz * vertices[i + 2];
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(places, 3));
  geometry.setAttribute("normal", new BufferAttribute(normals, 3, true));
  geometry.setIndex(new BufferAttribute(triangles, 1));
  geometry.boundingBox = new Box3(new Vector3(...low), new Vector3(...low.map((value, i) => value + STEPS * step[i])));
  geometry.boundingSphere = geometry.boundingBox.getBoundingSphere(new Sphere());
  return geometry;
}

// The canvas: as fine as the processor that draws it allows.
import { type Camera, type Color, Mesh, MeshBasicMaterial, OrthographicCamera, PlaneGeometry, Scene, Vector2, WebGLRenderer } from "three";

/** [ms] without a new picture: the machine rests. Slow pictures follow each other slowly. */
const CALM = 250;
const LONGEST_CALM = 2000;
const CALM_PICTURES = 4;
const FINEST = 2;
const VEIL = 0.75; // opacity of what makes a picture behind another one pale

function bySoftware(context: WebGL2RenderingContext): boolean {
  const known = context.getExtension("WEBGL_debug_renderer_info");
  const name = context.getParameter(known?.UNMASKED_RENDERER_WEBGL ?? context.RENDERER) as string;
  return /swiftshader|llvmpipe|softpipe|software|basic render/i.test(name);
}

export class Screen {
  readonly canvas: HTMLCanvasElement;
  private readonly renderer: WebGLRenderer;
  private readonly software: boolean;
  private fine = true;
  private film = false;
  private rest = 0;
  private before = 0;
  private readonly veil = new Mesh(new PlaneGeometry(2, 2), new MeshBasicMaterial({ transparent: true, opacity: VEIL, depthTest: false }));

  /** `redraw` is asked for when the machine rests: then software has time for a finer picture. */
  constructor(private readonly redraw: () => void) {
    const wishes = { alpha: false, depth: true, stencil: false, preserveDrawingBuffer: true };
    const canvas = document.createElement("canvas");
    const context = canvas.getContext("webgl2", { ...wishes, antialias: false });
    // Smooth edges by several samples in each pixel take software several times as long.
    this.software = context !== null && bySoftware(context);
    if (!this.software) context?.getExtension("WEBGL_lose_context")?.loseContext();
    this.renderer = new WebGLRenderer(context !== null && this.software ? { canvas, context, ...wishes } : { ...wishes, antialias: true });
    this.canvas = this.renderer.domElement;
    this.ratio(!this.software);
  }

  size(width: number, height: number): void {
    this.renderer.setSize(width, height);
  }

  draw(scene: Scene, camera: Camera): void {
    if (this.software) this.soften();
    this.renderer.render(scene, camera);
  }

  /** Two pictures of a scene, each posed before it is drawn: the first left of the second, or pale behind it. */
  pair(scene: Scene, camera: Camera, beside: boolean, poses: (() => void)[]): void {
    if (this.software) this.soften();
    const { renderer } = this;
    const { background } = scene;
    const { x: width, y: height } = renderer.getSize(new Vector2());
    renderer.autoClear = false;
    renderer.setScissorTest(beside);
    poses.forEach((pose, k) => {
      pose();
      if (beside) {
        renderer.setViewport((k * width) / 2, 0, width / 2, height);
        renderer.setScissor((k * width) / 2, 0, width / 2, height);
      } else if (k === 1) {
        this.veil.material.color = background as Color;
        renderer.render(new Scene().add(this.veil), new OrthographicCamera(-1, 1, 1, -1, -1, 1));
        renderer.clearDepth();
        scene.background = null;
      }
      renderer.render(scene, camera);
    });
    scene.background = background;
    renderer.setScissorTest(false);
    renderer.setViewport(0, 0, width, height);
    renderer.autoClear = true;
  }

  /** All pictures fine, or as usual: those of a film have time. */
  filming(on: boolean): void {
    clearTimeout(this.rest);
    this.rest = on ? -1 : 0;
    this.film = on;
  }

  /** While pictures follow each other each has the pixels of the page; one that stays has more, and smooth edges. */
  private soften(): void {
    const resting = this.rest < 0;
    if (this.fine !== resting) this.ratio(resting);
    clearTimeout(this.rest);
    const now = performance.now();
    const calm = Math.min(Math.max(CALM_PICTURES * (now - this.before), CALM), LONGEST_CALM);
    this.before = now;
    this.rest = this.film ? -1 : resting ? 0 : setTimeout(() => {
      this.rest = -1;
      this.redraw();
    }, calm);
  }

  private ratio(fine: boolean): void {
    this.fine = fine;
    const own = Math.min(window.devicePixelRatio, FINEST);
    this.renderer.setPixelRatio(this.software ? (fine ? FINEST : Math.min(own, 1)) : own);
  }
}

// The canvas: as fine as the processor that draws it allows.
import { type Camera, type Color, Mesh, MeshBasicMaterial, OrthographicCamera, PlaneGeometry, Scene, Vector2, WebGLRenderer } from "three";

/** [ms] without a new picture: the machine rests. Slow pictures follow each other slowly. */
const CALM = 250;
const LONGEST_CALM = 2000;
const CALM_PICTURES = 4;
const FINEST = 2;
const VEIL = 0.75; // opacity of what makes pictures behind another one pale

/** What poses a scene before it is drawn, one on another: all but the last pale. */
export type Panel = (() => void)[];

function bySoftware(context: WebGL2RenderingContext): boolean {
  const known = context.getExtension("WEBGL_debug_renderer_info");
  const name = context.getParameter(known?.UNMASKED_RENDERER_WEBGL ?? context.RENDERER) as string;
  return /swiftshader|llvmpipe|softpipe|software|basic render/i.test(name);
}

export class Screen {
  readonly renderer: WebGLRenderer;
  film = false; // its pictures have time: all are fine
  private readonly software: boolean;
  private rest = 0;
  private before = 0;
  private readonly veil = new Mesh(new PlaneGeometry(2, 2), new MeshBasicMaterial({ transparent: true, opacity: VEIL, depthTest: false }));

  constructor() {
    const wishes = { alpha: false, depth: true, stencil: false, preserveDrawingBuffer: true };
    const canvas = document.createElement("canvas");
    const context = canvas.getContext("webgl2", { ...wishes, antialias: false });
    // Smooth edges by several samples in each pixel take software several times as long.
    this.software = context !== null && bySoftware(context);
    if (!this.software) context?.getExtension("WEBGL_lose_context")?.loseContext();
    this.renderer = new WebGLRenderer(context !== null && this.software ? { canvas, context, ...wishes } : { ...wishes, antialias: true });
    this.ratio(!this.software);
  }

  /** By software, pictures that follow each other have the pixels of the page; one that stays has more, and smooth edges. */
  draw(scene: Scene, camera: Camera, panels: Panel[]): void {
    this.ratio(this.film || !this.software);
    this.paint(scene, camera, panels);
    if (this.film || !this.software) return;
    clearTimeout(this.rest);
    const now = performance.now();
    const calm = Math.min(Math.max(CALM_PICTURES * (now - this.before), CALM), LONGEST_CALM);
    this.before = now;
    this.rest = setTimeout(() => {
      this.ratio(true);
      this.paint(scene, camera, panels);
    }, calm);
  }

  /** Panels side by side. */
  private paint(scene: Scene, camera: Camera, panels: Panel[]): void {
    const { renderer } = this;
    const background = scene.background as Color;
    const { x: width, y: height } = renderer.getSize(new Vector2());
    renderer.autoClear = false; // but for a background
    renderer.setScissorTest(true);
    panels.forEach((poses, k) => {
      const part = [(k * width) / panels.length, 0, width / panels.length, height] as const;
      renderer.setViewport(...part);
      renderer.setScissor(...part);
      poses.forEach((pose, i) => {
        if (i > 0 && i === poses.length - 1) {
          this.veil.material.color = background;
          renderer.render(new Scene().add(this.veil), new OrthographicCamera(-1, 1, 1, -1, -1, 1));
          renderer.clearDepth();
        }
        pose();
        renderer.render(scene, camera);
        scene.background = null;
      });
      scene.background = background;
    });
  }

  private ratio(fine: boolean): void {
    const own = Math.min(window.devicePixelRatio, FINEST);
    const wanted = this.software ? (fine ? FINEST : Math.min(own, 1)) : own;
    if (this.renderer.getPixelRatio() !== wanted) this.renderer.setPixelRatio(wanted);
  }
}

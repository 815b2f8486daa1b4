// The picture as SVG: faces from the back to the front, names as text.
import { type BufferGeometry, Color, Line, Mesh, Sprite, Vector3, type Camera, type Object3D, type Scene } from "three";
import { SVGRenderer } from "three/examples/jsm/renderers/SVGRenderer.js";

/** `width` and `height` in pixels. */
export function drawing(scene: Scene, camera: Camera, width: number, height: number): string {
  const hidden: Object3D[] = [];
  const names: Sprite[] = [];
  scene.traverseVisible((object) => {
    if (object instanceof Sprite) names.push(object);
    const empty = (object instanceof Line || object instanceof Mesh) && !((object.geometry as BufferGeometry).getAttribute("position")?.count > 0);
    if (empty || object instanceof Sprite) hidden.push(object);
  });
  for (const object of hidden) object.visible = false;
  const renderer = new SVGRenderer();
  renderer.setSize(width, height);
  renderer.setClearColor(scene.background instanceof Color ? scene.background : new Color("white"), 1);
  renderer.setPrecision(2);
  renderer.render(scene, camera);
  for (const object of hidden) object.visible = true;
  const svg = renderer.domElement as unknown as SVGElement;
  svg.setAttribute("xmlns", "http://www.w3.org/2000/svg");
  for (const sprite of names) {
    const at = sprite.getWorldPosition(new Vector3()).project(camera);
    const text = document.createElementNS("http://www.w3.org/2000/svg", "text");
    const given = { x: (at.x * width) / 2, y: (-at.y * height) / 2, style: "text-anchor: middle; font: 12px sans-serif; fill: #64748b" };
    for (const [name, value] of Object.entries(given)) text.setAttribute(name, `${value}`);
    text.textContent = `${sprite.userData.words}`;
    svg.append(text);
  }
  return new XMLSerializer().serializeToString(svg);
}

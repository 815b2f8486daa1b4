// Inflates the program of the page and starts it.
import { inflate } from "./packed.ts";

void inflate(document.getElementById("code")?.textContent ?? "").then((code) => {
  const script = document.createElement("script");
  script.src = URL.createObjectURL(new Blob([code], { type: "text/javascript" }));
  document.body.append(script);
});

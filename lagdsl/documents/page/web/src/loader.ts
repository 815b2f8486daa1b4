// Inflates the program of the page and starts it.
const packed = document.getElementById("code")?.textContent ?? "";
const letters = atob(packed);
const bytes = new Uint8Array(letters.length);
for (let i = 0; i < letters.length; ++i) bytes[i] = letters.charCodeAt(i);
const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
void new Response(stream).text().then((text) => {
  const script = document.createElement("script");
  script.src = URL.createObjectURL(new Blob([text], { type: "text/javascript" }));
  document.body.append(script);
});

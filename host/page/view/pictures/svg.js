// Drawing context that writes SVG. It has the methods of a canvas that the flat pictures use, so that one function draws on both.

class SvgPen {
  path = "";
  dash = [];
  globalAlpha = 1;
  lineCap = "round";
  lineWidth = 1;
  strokeStyle = "";
  fillStyle = "";
  font = "";
  textAlign = "left";

  constructor(ground, [width, height]) {
    this.size = [width, height];
    this.parts = [`<rect width="${width}" height="${height}" fill="${ground}"/>`];
  }

  beginPath() {
    this.path = "";
  }

  moveTo(x, y) {
    this.path += `M${SvgPen.coordinates(x, y)}`;
  }

  lineTo(x, y) {
    this.path += `L${SvgPen.coordinates(x, y)}`;
  }

  closePath() {
    this.path += "Z";
  }

  /** Adds a complete circle to the path. */
  arc(x, y, radius) {
    const r = radius.toFixed(1);
    this.path += `M${SvgPen.coordinates(x - radius, y)}a${r} ${r} 0 1 0 ${2 * r} 0a${r} ${r} 0 1 0 ${-2 * r} 0Z`;
  }

  setLineDash(dash) {
    this.dash = dash;
  }

  stroke() {
    const dash = this.dash.length ? ` stroke-dasharray="${this.dash.join(" ")}"` : "";
    const line = `stroke="${this.strokeStyle}" stroke-width="${this.lineWidth}" stroke-linecap="${this.lineCap}"`;
    this.add(`<path d="${this.path}" fill="none" ${line} stroke-linejoin="round"${dash}`, "/>");
  }

  fill() {
    this.add(`<path d="${this.path}" fill="${this.fillStyle}"`, "/>");
  }

  fillText(text, x, y) {
    const anchor = { left: "start", center: "middle", right: "end" }[this.textAlign];
    const [size] = this.font.split("px");
    const escaped = text.replace(/&/g, "&amp;").replace(/</g, "&lt;");
    const style = `font-family="sans-serif" font-size="${size}" text-anchor="${anchor}" fill="${this.fillStyle}"`;
    this.add(`<text x="${x.toFixed(1)}" y="${y.toFixed(1)}" ${style}`, `>${escaped}</text>`);
  }

  add(start, end) {
    const opacity = this.globalAlpha === 1 ? "" : ` opacity="${this.globalAlpha.toFixed(3)}"`;
    this.parts.push(start + opacity + end);
  }

  static coordinates(x, y) {
    return `${x.toFixed(1)} ${y.toFixed(1)}`;
  }

  toString() {
    const [width, height] = this.size;
    const head = `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${width} ${height}"`;
    return `${head} width="${width}" height="${height}">\n${this.parts.join("\n")}\n</svg>\n`;
  }
}

// The axis draws a curve on the unit sphere.

/** Draws the curve of the axis on the unit sphere, seen from the azimuth of the 3-D picture. */
function drawSphere(canvas, { scene, now, past, view, colours, comparison }) {
  const { pen, size } = sheet(canvas, colours.card);
  // the elevation is greater than in the 3-D picture, because most curves are near the upper pole
  const camera = new Camera({ ...view, elevation: Math.min(1.5, view.elevation + 0.4) }, [0, 0, 0], 1.09, size);
  const project = (point) => camera.project(point);
  // a point of the sphere is visible if it is on the near side of the circle at which lines of sight are tangents
  const seen = (point) => dot(point, camera.position) >= 1;
  const edge = camera.focus / Math.sqrt(camera.distance ** 2 - 1);
  const [cx, cy] = camera.middle;
  const shade = pen.createRadialGradient(cx - 0.35 * edge, cy - 0.45 * edge, 0.1 * edge, cx, cy, edge);
  shade.addColorStop(0, colours.ground);
  shade.addColorStop(1, colours.sphere);
  disc(pen, [cx, cy], edge, shade);
  const onSphere = (points, style, width, dash) => {
    for (const [front, alpha] of [[false, 0.25], [true, 1]]) {
      pen.globalAlpha = alpha;
      pen.beginPath();
      points.forEach((point, i) => {
        const [x, y] = project(point);
        if (i && seen(point) === front) pen.lineTo(x, y);
        else pen.moveTo(x, y);
      });
      stroke(pen, style, width, dash);
    }
    pen.globalAlpha = 1;
  };
  const parallel = (u) => circle(Math.sqrt(Math.max(0, 1 - u * u)), u);
  [-60, -30, 0, 30, 60].forEach((degrees) => onSphere(parallel(Math.sin((degrees * Math.PI) / 180)), colours.grid, 0.7));
  [0, 30, 60, 90, 120, 150].forEach((degrees) => {
    const [c, s] = [Math.cos((degrees * Math.PI) / 180), Math.sin((degrees * Math.PI) / 180)];
    onSphere(circle(1, 0).map(([x, y]) => [x * c, x * s, y]), colours.grid, 0.7);
  });
  [...new Set(scene.e.slice(0, 2))].forEach((u, i) => onSphere(parallel(u), colours.bound, 1.3, DASHES[i]));
  const pixels = past.map(({ axis }) => [...project(axis), seen(axis)]);
  for (const front of [false, true]) {
    fading(pen, pixels, colours.axis, 2, (pixel) => (pixel[3] === front ? (front ? 1 : 0.3) : 0));
  }
  if (comparison) disc(pen, project(comparison.axis), 4, colours.comparison);
  const tip = project(now.axis);
  trace(pen, [project([0, 0, 0]), tip]);
  stroke(pen, colours.ink, 1.3);
  disc(pen, project([0, 0, 0]), 2.2, colours.ink);
  disc(pen, tip, 4, colours.axis);
}

import * as messages from "../messages";
import { type Photograph, SAMPLE } from "./photograph";

const { width: WIDTH, height: HEIGHT } = SAMPLE;
const HORIZON = 0.66 * HEIGHT;

/** A picture to begin with, drawn here and the same every time: dusk over hills and water, with ferns. */
export function drawSample(): Photograph {
  const canvas = document.createElement("canvas");
  canvas.width = WIDTH;
  canvas.height = HEIGHT;
  const context = canvas.getContext("2d", { willReadFrequently: true });
  if (!context) throw new Error(messages.noCanvas);
  sky(context);
  sun(context);
  hills(context);
  water(context);
  meadow(context);
  ferns(context);
  const { data } = context.getImageData(0, 0, WIDTH, HEIGHT);
  return { pixels: data, width: WIDTH, height: HEIGHT, name: messages.sampleName };
}

type Context = CanvasRenderingContext2D;

/** Numbers from 0 to 1 that look thrown, the same on every machine. */
function dice(seed: number): () => number {
  let state = seed;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return ((state >>> 8) & 0xffff) / 0x10000;
  };
}

function down(context: Context, top: number, bottom: number, stops: readonly [number, string][]) {
  const gradient = context.createLinearGradient(0, top, 0, bottom);
  for (const [at, colour] of stops) gradient.addColorStop(at, colour);
  return gradient;
}

function sky(context: Context): void {
  context.fillStyle = down(context, 0, HORIZON, [
    [0, "#1d2b5c"],
    [0.35, "#4a4f8f"],
    [0.62, "#b0668f"],
    [0.82, "#ee9a6b"],
    [1, "#ffd98f"],
  ]);
  context.fillRect(0, 0, WIDTH, HEIGHT);
  const next = dice(7);
  for (let i = 0; i < 130; i++) {
    const y = next() ** 2 * 0.5 * HEIGHT;
    context.fillStyle = `rgba(255, 250, 235, ${(0.85 * (1 - y / (0.5 * HEIGHT)) * next()).toFixed(3)})`;
    context.beginPath();
    context.arc(next() * WIDTH, y, 0.7 + 1.5 * next() ** 3, 0, 2 * Math.PI);
    context.fill();
  }
  // Long clouds, lit from below.
  for (let i = 0; i < 26; i++) {
    const [x, y] = [next() * WIDTH, (0.28 + 0.34 * next()) * HEIGHT];
    const [across, up] = [90 + 240 * next(), 5 + 13 * next()];
    context.fillStyle = `rgba(255, ${150 + Math.round(70 * next())}, 150, ${(0.08 + 0.16 * next()).toFixed(3)})`;
    context.beginPath();
    context.ellipse(x, y, across, up, 0.02 * (next() - 0.5), 0, 2 * Math.PI);
    context.fill();
  }
}

const SUN = { x: 0.64 * WIDTH, y: HORIZON - 0.075 * HEIGHT, r: 0.062 * HEIGHT } as const;

function sun(context: Context): void {
  const glow = context.createRadialGradient(SUN.x, SUN.y, 0, SUN.x, SUN.y, 0.5 * HEIGHT);
  glow.addColorStop(0, "rgba(255, 240, 190, 0.95)");
  glow.addColorStop(0.14, "rgba(255, 214, 140, 0.6)");
  glow.addColorStop(1, "rgba(255, 190, 120, 0)");
  context.fillStyle = glow;
  context.fillRect(0, 0, WIDTH, HORIZON);
  context.fillStyle = "#fff6d8";
  context.beginPath();
  context.arc(SUN.x, SUN.y, SUN.r, 0, 2 * Math.PI);
  context.fill();
}

function hills(context: Context): void {
  const rows = [
    { base: 0.015, height: 0.15, colour: "#7a5a88", seed: 3 },
    { base: 0.005, height: 0.095, colour: "#57487a", seed: 11 },
    { base: 0, height: 0.05, colour: "#37355f", seed: 23 },
  ];
  for (const { base, height, colour, seed } of rows) {
    const next = dice(seed);
    const waves = Array.from({ length: 6 }, (_, i) => ({
      at: next() * 7,
      size: 0.62 ** i,
      often: 2.1 * 1.9 ** i,
    }));
    context.fillStyle = colour;
    context.beginPath();
    context.moveTo(0, HORIZON);
    for (let x = 0; x <= WIDTH; x += 3) {
      const ridge = waves.reduce((sum, w) => sum + w.size * Math.sin((w.often * x) / WIDTH + w.at), 0);
      context.lineTo(x, HORIZON - (base + height * (0.55 + 0.28 * ridge)) * HEIGHT);
    }
    context.lineTo(WIDTH, HORIZON);
    context.fill();
  }
}

function water(context: Context): void {
  context.fillStyle = down(context, HORIZON, HEIGHT, [
    [0, "#f3b67c"],
    [0.2, "#a9688f"],
    [0.6, "#3f4478"],
    [1, "#1b2450"],
  ]);
  context.fillRect(0, HORIZON, WIDTH, HEIGHT - HORIZON);
  const next = dice(31);
  for (let i = 0; i < 420; i++) {
    const part = next();
    const y = HORIZON + part ** 1.6 * (HEIGHT - HORIZON);
    const near = (y - HORIZON) / (HEIGHT - HORIZON);
    const far = (next() + next() + next() - 1.5) * (0.05 + 0.3 * near) * WIDTH;
    const long = (10 + 70 * next()) * (0.3 + near);
    context.fillStyle = `rgba(255, 226, 165, ${(0.5 * (1 - near) * next() + 0.05).toFixed(3)})`;
    context.fillRect(SUN.x + far - long / 2, y, long, 1 + 2.4 * near);
  }
}

function meadow(context: Context): void {
  const next = dice(47);
  const edge = (x: number) =>
    HEIGHT * (0.9 + 0.045 * Math.sin((3.4 * x) / WIDTH + 0.8) + 0.012 * Math.sin((17 * x) / WIDTH));
  context.fillStyle = "#12261d";
  context.beginPath();
  context.moveTo(0, HEIGHT);
  for (let x = 0; x <= WIDTH; x += 4) context.lineTo(x, edge(x));
  context.lineTo(WIDTH, HEIGHT);
  context.fill();
  for (let i = 0; i < 900; i++) {
    const x = next() * WIDTH;
    const y = edge(x) + next() * 0.12 * HEIGHT;
    const [lean, tall] = [(next() - 0.5) * 26, 16 + 40 * next()];
    context.strokeStyle = `hsl(${110 + 40 * next()} ${30 + 25 * next()}% ${9 + 15 * next()}%)`;
    context.lineWidth = 1 + 1.3 * next();
    context.beginPath();
    context.moveTo(x, y);
    context.quadraticCurveTo(x + 0.2 * lean, y - 0.6 * tall, x + lean, y - tall);
    context.stroke();
  }
}

function ferns(context: Context): void {
  const plants: readonly [x: number, y: number, size: number, turn: number, hue: number, light: number][] = [
    [0.42, 0.985, 0.3, 0.42, 158, 17],
    [0.955, 0.985, 0.36, -0.2, 156, 16],
    [0.33, 0.99, 0.4, -0.5, 154, 19],
    [0.8, 1, 0.42, -0.42, 148, 22],
    [0.87, 1.01, 0.46, 0.16, 144, 26],
    [0.2, 1.01, 0.66, 0.12, 146, 27],
    [0.13, 1.01, 0.5, -0.46, 140, 31],
    [0.16, 1.02, 0.42, 0.62, 138, 34],
  ];
  context.lineCap = "round";
  for (const [x, y, size, turn, hue, light] of plants) {
    context.save();
    context.translate(x * WIDTH, y * HEIGHT);
    context.rotate(turn);
    context.strokeStyle = `hsl(${hue} 44% ${light}%)`;
    frond(context, size * HEIGHT, 22, Math.sign(turn) * 0.026, true);
    context.restore();
  }
}

/** A stem that curls over, with leaves that taper to its tip and are small fronds themselves. */
function frond(context: Context, length: number, steps: number, curl: number, whole: boolean): void {
  context.save();
  for (let i = 0; i < steps; i++) {
    const left = 1 - i / steps;
    const step = (length / steps) * (0.7 + 0.6 * left);
    context.lineWidth = Math.max(0.8, length * (whole ? 0.014 : 0.02) * left);
    context.beginPath();
    context.moveTo(0, 0);
    context.lineTo(0, -step);
    context.stroke();
    context.translate(0, -step);
    context.rotate(curl * (1 + 1.6 * (1 - left)));
    const leaf = length * (whole ? 0.42 : 0.125) * left ** 0.8 * Math.min(1, 0.35 + 0.16 * i);
    if ((whole && i < 3) || leaf < 1.5) continue;
    for (const side of [-1, 1]) {
      context.save();
      context.rotate(side * (0.75 + 0.4 * left));
      if (whole) {
        frond(context, leaf, 14, -0.035 * side, false);
      } else {
        context.lineWidth = Math.max(0.8, leaf * 0.42);
        context.beginPath();
        context.moveTo(0, 0);
        context.lineTo(0, -leaf);
        context.stroke();
      }
      context.restore();
    }
  }
  context.restore();
}

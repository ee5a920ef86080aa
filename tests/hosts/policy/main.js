import "./node_modules/frond-ifs/frond-view.module.js";
import { createPool } from "./node_modules/frond-ifs/pool.js";

const pool = createPool({ size: 1 });
const halves = [
  [0.5, 0, 0, 0.5, 0, 0],
  [0.5, 0, 0, 0.5, 0.5, 0],
];
const { verdict } = await pool.connectedness({ maps: halves }, { epsilon: 1e-4 });
document.querySelector("output").textContent = `The pool says: ${verdict}`;

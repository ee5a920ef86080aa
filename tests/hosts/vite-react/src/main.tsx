import { StrictMode } from "react";
import { createRoot } from "react-dom/client";
import { Morph } from "./Morph";

createRoot(document.getElementById("root") as HTMLElement).render(
  <StrictMode>
    <Morph t={0.4} />
  </StrictMode>,
);

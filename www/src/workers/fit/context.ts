import type { FitModule } from "#wasm/fit";
import type { Context as Plain } from "../lanes/task";

/** What a task of the fit has at hand. */
export interface Context<Progress = never> extends Plain<Progress> {
  readonly fit: FitModule;
}

import type { Page } from "@playwright/test";

/** A browser that runs. */
export interface Opened {
  /** A page with nothing kept from others. */
  newPage(): Promise<Page>;
  /** Where the driver does not tell what the page says: asks for it. */
  listen?(page: Page): Promise<void>;
  close(): Promise<void>;
}

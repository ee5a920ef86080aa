import type { CDPSession } from "@playwright/test";
import { expect, test } from "./fixture";

interface Place {
  x: number;
  y: number;
}

function touch(session: CDPSession, type: "touchStart" | "touchMove" | "touchEnd", points: Place[]) {
  return session.send("Input.dispatchTouchEvent", {
    type,
    touchPoints: points.map((point, id) => ({ ...point, id })),
  });
}

test("the map is pinched, moved and pressed with fingers", async ({ studio, page }) => {
  await studio.open("a=dragon-3&b=gasket&path=straight");
  await studio.square.evaluate((square) => square.scrollIntoView({ block: "center" }));
  const session = await page.context().newCDPSession(page);
  await test.step("a tap takes a point", async () => {
    const { x, y } = await studio.place(-0.6, 1.2);
    await page.touchscreen.tap(x, y);
    await expect.poll(async () => (await studio.scene()).locus?.at?.[0] ?? 9).toBeCloseTo(-0.6, 1);
    await page.getByRole("button", { name: "Back to the path" }).tap();
    expect((await studio.scene()).locus).toBeUndefined();
  });
  await test.step("a finger held still looks, and takes nothing", async () => {
    await studio.square.evaluate((square) => square.scrollIntoView({ block: "center" }));
    const { x, y } = await studio.place(1.6, 0.4);
    await touch(session, "touchStart", [{ x, y }]);
    await expect(page.locator(".locus-preview")).toBeVisible();
    await touch(session, "touchEnd", []);
    await expect(page.locator(".locus-preview")).toBeHidden();
    expect((await studio.scene()).locus).toBeUndefined();
  });
  await test.step("two fingers enlarge, one then moves", async () => {
    const { x, y } = await studio.place(0.2, 1.5);
    const both = (d: number) => [
      { x: x - d / 2, y },
      { x: x + d / 2, y },
    ];
    await touch(session, "touchStart", both(40));
    for (let d = 60; d <= 160; d += 20) await touch(session, "touchMove", both(d));
    await touch(session, "touchEnd", []);
    const near = (await studio.scene()).locus;
    expect(near?.zoom).toBeGreaterThan(3);
    expect(near?.at).toBeUndefined();
    const from = await studio.place(1.7, 0.6);
    await touch(session, "touchStart", [from]);
    for (let i = 1; i <= 5; i++) await touch(session, "touchMove", [{ x: from.x - 8 * i, y: from.y }]);
    await touch(session, "touchEnd", []);
    const moved = (await studio.scene()).locus;
    expect(moved?.x).toBeGreaterThan(near?.x ?? 0);
    expect(moved?.zoom).toBe(near?.zoom);
  });
});

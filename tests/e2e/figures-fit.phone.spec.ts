import { expect, test } from "./fixture";

test("a finger drags the middle point of Figure 1", async ({ page }) => {
  await page.goto("./#figures/c1");
  const middle = page.getByRole("button", { name: /^Middle point/ });
  await expect(middle).toHaveAccessibleName(/t = 0\.50, x = 1\.00/);
  await middle.scrollIntoViewIfNeeded();
  const box = await middle.boundingBox();
  if (!box) throw new Error("the point is not on the page");
  expect(Math.min(box.width, box.height)).toBeGreaterThanOrEqual(44);
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  const finger = await page.context().newCDPSession(page);
  const touch = (type: "touchStart" | "touchMove" | "touchEnd", points: { x: number; y: number }[]) =>
    finger.send("Input.dispatchTouchEvent", { type, touchPoints: points });
  await touch("touchStart", [{ x, y }]);
  for (let i = 1; i <= 5; i++) await touch("touchMove", [{ x: x + 8 * i, y: y + 6 * i }]);
  await touch("touchEnd", []);
  await expect(middle).not.toHaveAccessibleName(/t = 0\.50|x = 1\.00/);
});

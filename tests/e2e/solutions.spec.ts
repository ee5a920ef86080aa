/** That the exercises of all lessons are solved by what teachers are told, which links open. */
import { LESSONS } from "./figure-pages";
import { expect, test } from "./fixture";

const SOLUTIONS: Record<string, string> = {
  e1: "x1.second=0.65&x1.third=0.65&x2.third=0.55",
  e2: "x1.throws=32&x2.part=0.6",
  e3: "x1.cells=1,3,4,5,7&x2.cells=1,4",
  e4: "x1.r=0.48&x2.n=5",
  e5: "x1.size=16&x2.size=27",
  e6: "x1.angle=120&x2.angle=90",
  e7: "x1.way=0.5,0.1&x2.way=0.2,0.45",
  e8: "x1.s=0,0.7&x2.s=0.5,0",
  e9: "x1.third=0.38&x2.scales=0.72,0.42,0.28",
  e10: "x1.pairing=132&x2.pairing=231",
  e11: "x1.code=2311&x2.code=1231",
  e12: "x1.steps=10&x2.start=gasket",
  e13: "x1.missing=4&x2.lean=0",
  e14: "x1.scale=0.93&x2.point=6",
  e15: "x1.weights=0.4,0.6,1&x2.chance=0.36",
  e16: "x1.address=1(3)&x2.address=(12)&x3.addresses=31(2);32(1)",
  e17: "x1.scale=0.25&x2.scale=0.5",
  e18: "x1.percent=60&x2.percents=0,70,70,0",
  e20: "x1.place=0.45,0.5&x2.places=0.446,0.447",
  e21: "x1.b=0.2,2.5,-0.3&x2.b=1.2,1.8,0.2",
  e22: "x1.roughness=0.25&x2.locality=3",
  e23: "x1.copies=0:0.68:0.6:0.85:0;-0.3:0.35:0.6:0.95:60;0.3:0.35:0.6:0.95:-60;0:0.4:0.3:1:0&x2.s=0.7",
  e24: "x1.eye=45,35&x2.eye=60,35",
  e25: "x1.angle=81&x2.size=0.708",
  e26: "x1.size=0.63&x2.percent=80",
  e27: "x1.bytes=36&x2.s=0.7",
  e29: "x1.s=0.5&x2.s=0.71",
  e30: "x1.scale=0.8&x1.push=2&x2.steps=A,B,A,B,A,B,A,B,A,B,A,B",
  e31: "x1.throws=1213&x2.address=2312",
  e28: "x1.turn=120&x2.shift=0.3",
};

test("every exercise is solved by the solution that its teacher has", async ({ page }) => {
  await page.emulateMedia({ reducedMotion: "reduce" });
  expect(Object.keys(SOLUTIONS).sort()).toEqual([...LESSONS].sort());
  await page.goto("./#learn");
  for (const [lesson, state] of Object.entries(SOLUTIONS)) {
    await test.step(lesson, async () => {
      await page.evaluate((to) => location.assign(to), `#learn/${lesson}/${state}`);
      await page.locator(`nav [aria-current=page][href="#learn/${lesson}"]`).waitFor();
      const exercises = page.getByTestId("exercise");
      for (const exercise of await exercises.all())
        await expect(exercise.locator("[data-solved]"), lesson).toHaveCount(1);
      expect(await exercises.count(), lesson).toBeGreaterThanOrEqual(2);
    });
  }
});

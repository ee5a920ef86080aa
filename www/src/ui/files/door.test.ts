import { expect, it } from "vitest";
import { openFile, takeFiles } from "./door";

it("keeps what comes before anybody takes it", () => {
  const [early, later] = [new File(["a"], "early.ifs"), new File(["b"], "later.ifs")];
  openFile([early]);
  const taken: string[] = [];
  const end = takeFiles(([first]) => taken.push(first.name));
  expect(taken).toEqual(["early.ifs"]);
  openFile([later]);
  end();
  const again = takeFiles(([first]) => taken.push(`again ${first.name}`));
  again();
  expect(taken).toEqual(["early.ifs", "later.ifs"]);
});

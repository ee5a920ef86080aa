import { expect, test } from "vitest";
import { commands } from "./commands";
import { stageCommand } from "./stage/keys";

test("every key that help says the stage has does something there", () => {
  const stage = commands.filter(({ group }) => group === "With the picture focused");
  expect(stage.length).toBeGreaterThan(3);
  for (const way of stage.flatMap(({ keys }) => keys)) {
    const key =
      { "←": "ArrowLeft", "→": "ArrowRight", "↑": "ArrowUp", "↓": "ArrowDown", "−": "-" }[way] ?? way;
    const press = {
      key: key.length === 1 ? key.toLowerCase() : key,
      code: "",
      shiftKey: false,
      ctrlKey: false,
    };
    expect(stageCommand({ ...press, metaKey: false, altKey: false }), way).not.toBeNull();
  }
});

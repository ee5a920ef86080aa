import { signal } from "@preact/signals";
import { useState } from "preact/hooks";
import { GREY } from "#style/colours";
import { Button, IconButton } from "../controls/Button";
import { HoldButton } from "../controls/HoldButton";
import { NumberField } from "../controls/NumberField";
import { Segmented } from "../controls/Segmented";
import { Select } from "../controls/Select";
import { Slider } from "../controls/Slider";
import { SliderField } from "../controls/SliderField";
import { SliderBreaks, SliderMark } from "../controls/SliderMarks";
import { Switch } from "../controls/Switch";
import { FileButton } from "../files/FileButton";
import { ColourField } from "../panel/ColourField";
import { PercentField } from "../strip/PercentField";
import { PlayButton } from "../strip/PlayButton";
import { LONG, State, Widget } from "./Widget";

const nothing = () => {};
const free = signal(false);
const held = signal(true);
const KINDS = ["plain", "quiet", "primary", "danger"] as const;

export function Controls() {
  return (
    <>
      <Buttons />
      <Widget name="IconButton" state="plain, on, off, disabled">
        <div class="row">
          <IconButton icon="swap" label="Swap" />
          <IconButton icon="loop" label="Loop" pressed />
          <IconButton icon="loop" label="Once" pressed={false} />
          <IconButton icon="bin" label="Delete" disabled />
        </div>
      </Widget>
      <Widget name="PlayButton" state="still, playing, nothing to play">
        <div class="row">
          <PlayButton playing={false} onToggle={nothing} />
          <PlayButton playing onToggle={nothing} />
          <PlayButton playing={false} onToggle={nothing} still="Nothing moves yet" />
        </div>
      </Widget>
      <Widget name="HoldButton" state="let go, held">
        <div class="row">
          <HoldButton held={free} title="Hold to compare">
            Compare
          </HoldButton>
          <HoldButton held={held} title="Hold to compare">
            Compare
          </HoldButton>
        </div>
      </Widget>
      <Widget name="ColourField">
        <ColourField label="Map 1" value={GREY} onChange={nothing} />
      </Widget>
      <Widget name="FileButton">
        <State name="plain">
          <FileButton label="A drawing" accept=".svg" onFile={nothing}>
            Open a file
          </FileButton>
        </State>
        <State name="disabled">
          <FileButton label="Another drawing" accept=".svg" onFile={nothing} disabled>
            Open a file
          </FileButton>
        </State>
      </Widget>
      <Choices />
      <Numbers />
    </>
  );
}

function Buttons() {
  return (
    <Widget name="Button">
      {KINDS.map((kind) => (
        <State key={kind} name={`${kind}: plain, with an icon, disabled`}>
          <div class="row">
            <Button kind={kind}>Plan</Button>
            <Button kind={kind} icon="add">
              Add
            </Button>
            <Button kind={kind} disabled>
              Plan
            </Button>
          </div>
        </State>
      ))}
      <State name="on and off">
        <div class="row">
          <Button pressed>On</Button>
          <Button pressed={false}>Off</Button>
        </div>
      </State>
      <State name="long words">
        <Button icon="save">{LONG}</Button>
      </State>
    </Widget>
  );
}

function Choices() {
  const [value, choose] = useState("one");
  const [on, turn] = useState(true);
  const options = [
    { value: "one", label: "One" },
    { value: "two", label: "Two" },
    { value: "three", label: "Not now", disabled: true },
  ];
  return (
    <>
      <Widget name="Segmented">
        <State name="one of three, the last disabled">
          <Segmented label="Choice" options={options} value={value} onChange={choose} />
        </State>
        <State name="long words" wide>
          <Segmented
            label="Long choice"
            options={[
              { value: "one", label: LONG },
              { value: "two", label: "Two" },
            ]}
            value={value}
            onChange={choose}
          />
        </State>
      </Widget>
      <Widget name="Switch">
        <State name="on and off">
          <Switch checked={on} onChange={turn}>
            Grid
          </Switch>
          <Switch checked={!on} onChange={(next) => turn(!next)}>
            Names
          </Switch>
        </State>
        <State name="long words">
          <Switch checked={on} onChange={turn}>
            {LONG}
          </Switch>
        </State>
      </Widget>
      <Widget name="Select">
        {[false, true].map((disabled) => (
          <State key={String(disabled)} name={disabled ? "disabled" : "plain"}>
            <Select aria-label="Ease" disabled={disabled}>
              <option>Even</option>
              <option>{LONG}</option>
            </Select>
          </State>
        ))}
      </Widget>
    </>
  );
}

function Numbers() {
  const [value, change] = useState(0.25);
  return (
    <>
      <Widget name="NumberField">
        <State name="plain, with a symbol, with a unit">
          <NumberField label="Length" value={value} onChange={change} />
          <NumberField label="Across" symbol="u" value={value} onChange={change} />
          <NumberField label="Turn" unit="°" value={value} onChange={change} />
        </State>
        <State name="terse, disabled">
          <NumberField label="Entry" symbol="a" terse value={value} onChange={change} />
          <NumberField label="Fixed" value={value} disabled onChange={nothing} />
        </State>
        <State name="error: type anything and press Enter">
          <NumberField label="Refused" value={value} onChange={() => "No number is taken here."} />
        </State>
        <State name="long words, many digits">
          <NumberField label={LONG} value={-123456.789012} digits={6} onChange={nothing} />
        </State>
      </Widget>
      <Widget name="PercentField" state="plain">
        <PercentField label="Moment" value={value} onChange={change} />
      </Widget>
      <Widget name="Slider">
        <State name="plain" wide>
          <Slider label="Plain" value={value} onChange={change} />
        </State>
        <State name="at its ends" wide>
          <Slider label="Least" value={0} onChange={nothing} />
          <Slider label="Most" value={1} onChange={nothing} />
        </State>
        <State name="with marks and breaks" wide>
          <Slider label="Marked" value={value} onChange={change}>
            <SliderMark at={0.5} title="Half" />
            <SliderBreaks breaks={[[0.7, 0.85]]} />
          </Slider>
        </State>
      </Widget>
      <Widget name="SliderField">
        <State name="plain" wide>
          <SliderField label="Depth" value={value} onChange={change} />
        </State>
        <State name="with ends, symbol and unit" wide>
          <SliderField
            label="Angle"
            symbol="φ"
            unit="°"
            ends={["0", "½", "1"]}
            value={value}
            onChange={change}
          />
        </State>
        <State name="long words" wide>
          <SliderField label={LONG} value={value} onChange={change} />
        </State>
      </Widget>
    </>
  );
}

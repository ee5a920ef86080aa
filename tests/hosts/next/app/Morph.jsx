"use client";
import { useEffect, useState } from "react";
import "frond-ifs/view";

export function Morph({ t }) {
  const [words, setWords] = useState("");
  const [here, setHere] = useState(false);
  useEffect(() => setHere(true), []);
  const heard = ({ detail }) => setWords(detail.words);
  return (
    <>
      {here && <frond-view a="dragon-3" b="gasket" t={t} controls verdict onverdict={heard} />}
      <output>{words}</output>
    </>
  );
}

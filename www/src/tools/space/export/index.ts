/** The export of space: loaded when it is first asked for. */
export { ExportDialog } from "./ExportDialog";

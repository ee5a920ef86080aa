import vue from "@vitejs/plugin-vue";

const isCustomElement = (tag) => tag === "frond-view";
export default { plugins: [vue({ template: { compilerOptions: { isCustomElement } } })] };

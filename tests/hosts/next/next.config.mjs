export default { serverExternalPackages: ["frond-ifs"] };

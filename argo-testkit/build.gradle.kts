plugins { `java-library` }

dependencies {
    compileOnly(libs.jason) // the user's project brings Jason
    api(project(":argo-arch"))
    testImplementation(libs.jason)
    testImplementation(libs.mockk)
}
